sed -i '2,$ s/input_x = 0/input_x = 1/; 2,$ s/input_y = 1/input_y = 0/' k.h && grep 'input_x = 1' k.h
