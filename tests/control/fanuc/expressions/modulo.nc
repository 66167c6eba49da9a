%
O0001
(rule: F 6.4 operands are rounded, sign of the dividend)
(expect: #1=1)
(expect: #2=3)
(expect: #3=0)
#1=7MOD2.6
#2=7MOD-4
#3=7.6MOD4
M30
%
