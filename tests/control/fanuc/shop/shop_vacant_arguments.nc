%
O0125(VACANT ARGUMENTS)
(rule: F 6.3: arguments that were not given)
(expect: path X1 Y2)
(expect: #100=1)
(expect: #101=2)
(expect: #102=1)
(expect: #103 vacant)
(expect: #104=0)
G65P9125A1.C0
G65P9125B2.D3
G65P9125
M30
O9125
IF[#1EQ#0]GOTO10
#100=#100+1
N10IF[#2NE#0]THEN#101=#2
IF[#3EQ0]THEN#102=1
IF[#7EQ0]THEN#103=1
#104=#104+#9
G0X#1Y#2Z#3
M99
%
