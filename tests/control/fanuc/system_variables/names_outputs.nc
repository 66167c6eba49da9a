%
O0001
(rule: F 6.5, 6.6: #_UO and #1100 are the same outputs)
(expect: #1=1)
(expect: #2=1)
(expect: #1103=1)
[#_UO[3]]=1
#1=[#_UO[3]]
#2=#1103
M30
%
