%
O0001
(rule: F 3.6 G34: F the lead, K its change, below 0 it falls)
(expect: path z5f500 t2:z-10 t3:z-20)
S300M03
G01Z5.F500.
G34Z-10.F2.K0.1
Z-20.F3.K-0.1
M30
%
