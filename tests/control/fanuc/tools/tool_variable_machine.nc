%
O0001
(rule: F 6.5 what the machine has is read)
(expect: #1=5)
(expect: #2=80)
(expect: #3=0)
#1=#13001
#2=#11002
#3=#11099
M30
%
