%
O0001
(rule: F 5.6 G75 in one line: I on the radius, K along Z, the return is No.5139)
(expect: path X50Z-10 x46f0.1 X46.6 x42 X42.6 x40 X50)
G99 G97 S500 M03
G00 X50. Z-10.
G75 X40. I2. F0.1
M30
%
