%
O0001
(rule: F 6.8 an I J K out of order starts the next triple; the later word wins)
(expect: #103=1)
(expect: #104=2)
(expect: #106=9)
G65P9100I1.J2.I3.D9.
M30
%
