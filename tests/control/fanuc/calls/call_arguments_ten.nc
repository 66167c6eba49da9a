%
O0001
(rule: F 6.8 up to ten triples: I10 J10 K10 are #31 #32 #33)
(expect: #121=31)
(expect: #122=32)
(expect: #123=33)
G65P9100I1.I2.I3.I4.I5.I6.I7.I8.I9.I31.J32.K33.
M30
%
