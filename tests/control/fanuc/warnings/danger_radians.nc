%
O0001
(rule: technologist, wrong motion: the control counts in degrees; said once of a run)
(expect: warning K5978 at 7:9)
#1=3.14159/4
#2=SIN[45.]+COS[0.785]
#3=10.*[SIN[#1]]
#4=COS[#1]
M30
%
