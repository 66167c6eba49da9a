%
O0001
(rule: F 6.5 #1100 to #1131: outputs, read back as the program has set them)
(expect: #1=0)
(expect: #2=1)
#1=#1105
#1105=1
#2=#1105
M30
%
