%
O0001
G99 G97 T0101 M03 S500
G00 X30. Z2.
G74 R0.5
G74 X20. Z-20. F0.1
M30
%
(args: run {file} -d fanuc-lathe -m lathe --commands {out})
(expect: 6:1 PS0066 UNAVAILABLE COMMAND IS IN THE MULTIPLE REPETITIVE CYCLES BLOCK: `G74` lacks words: `Q_`)
(exit: 3)
