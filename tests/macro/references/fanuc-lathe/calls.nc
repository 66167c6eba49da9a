%
O0001
G65 P9100 W2.
(    ^ leads: O9100.NC:1:2)
GOTO 20
(    ^ leads: 8:1)
N10 X5.
N20 M30
%
