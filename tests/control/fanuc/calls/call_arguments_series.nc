%
O0001
(rule: F 6.8 argument assignment II)
(expect: #100=1)
(expect: #101=2)
(expect: #103=3)
(expect: #104=4)
(expect: #105=5)
(expect: #106=6)
G65P9100A1.B2.I3.J4.K5.I6.
M30
%
