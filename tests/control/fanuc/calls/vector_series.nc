%
O0001
(rule: F 12 both kinds of arguments)
(expect: #101=1)
(expect: #102=2)
(expect: #104=3)
(expect: #105=4)
(expect: #106=5)
(expect: #107=6)
(expect: #124=0.01)
G65P9203A1.B2.I3.J4.K5.I6.
M30
O9203
#101=#1
#102=#2
#104=#4
#105=#5
#106=#6
#107=#7
G65P9204X10
M99
O9204
#124=#24
M99
%
