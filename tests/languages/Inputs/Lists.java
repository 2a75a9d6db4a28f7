/** The lists of a banded matrix, in parts. */
final class Lists {
  static void check(boolean holds) {
    if (!holds) throw new AssertionError();
  }

  public static void main(String[] arguments) {
    final int n = banded.JACOBIAN_Y_X_ROWS;
    check(n == 2100 && banded.JACOBIAN_Y_X_NONZEROS == 2 * n && banded.JACOBIAN_Y_X_ROW.length == 2 * n);
    for (int k = 0; k < 2 * n; ++k) {
      check(banded.JACOBIAN_Y_X_ROW[k] == k / 2 && banded.JACOBIAN_Y_X_COLUMN[k] == k / 2 + k % 2);
      check(banded.JACOBIAN_Y_X_ROW_BY_COLUMN[k] == k / 2);
      check(banded.JACOBIAN_Y_X_COLUMN[banded.JACOBIAN_Y_X_BY_COLUMN[k]] == (k + 1) / 2);
    }
    for (int i = 0; i <= n; ++i) check(banded.JACOBIAN_Y_X_ROW_START[i] == 2 * i);
    for (int j = 1; j <= n; ++j) check(banded.JACOBIAN_Y_X_COLUMN_START[j] == 2 * j - 1);
    System.out.println("lists are right");
  }
}
