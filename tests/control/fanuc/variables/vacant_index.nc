%
O0001
(rule: F 6.3 #[#1] is #0)
(expect: #2 vacant)
#2=5
#2=#[#1]
M30
%
