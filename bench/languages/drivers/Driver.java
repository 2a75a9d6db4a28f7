import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Scanner;

public final class Driver {
  public static void main(String[] arguments) throws Exception {
    final double[] values = Arrays.stream(Files.readString(Path.of("values")).trim().split("\\s+")).mapToDouble(Double::parseDouble).toArray();
    final double[] constants = new double[@CONSTANTS@], output = new double[@OUTPUTS@];
    final double first = values[0];
    @BASE@.preprocess(Arrays.copyOfRange(values, @INPUTS@, values.length), constants);
    final Scanner requests = new Scanner(System.in);
    while (requests.hasNextLong()) {
      final long calls = requests.nextLong(), begin = System.nanoTime();
      double sum = 0;
      for (long i = 0; i < calls; ++i) {
        values[0] = first + 1e-7 * (double)(i & 15);
        @BASE@.compute(values, constants, output);
        sum += output[0];
      }
      System.out.println((double)(System.nanoTime() - begin) / calls + " " + sum);
    }
  }
}
