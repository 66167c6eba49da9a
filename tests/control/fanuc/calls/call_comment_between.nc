%
O0001
(rule: F 1.5, 6.8: a comment stands between the words of a macro call; what is behind it are arguments)
(expect: #100=1)
(expect: #101=20)
(expect: #102=3)
(expect: #103=2)
G65P9101A1.(DIA)X20.
G65 P9102 (POCKET) A3. (TWICE) L2 ;
M30
O9101
#100=#1
#101=#24
M99
O9102
#102=#1
#103=#103+1
M99
%
