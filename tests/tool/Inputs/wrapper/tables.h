extern double grip_table[2];
