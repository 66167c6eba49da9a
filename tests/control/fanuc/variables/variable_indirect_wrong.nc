%
O0001
(rule: F 6.2 a computed number that does not exist)
(expect: alarm PS0115 K5410 at 6:1)
#1=50
#[#1]=1
M30
%
