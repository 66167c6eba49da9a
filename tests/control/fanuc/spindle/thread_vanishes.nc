%
O0001
(rule: F 3.6 G34: the lead falls to nothing: PS0313)
(expect: to Z5)
(expect: alarm PS0313 K5492 at 8:12)
S300M03
G01Z5.F500.
G34Z-20.F2.K-0.5
M30
%
