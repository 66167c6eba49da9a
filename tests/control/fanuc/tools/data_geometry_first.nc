%
O0001
(rule: F 3.4 G10 L11 to L13: H wear, D geometry, D wear)
(expect: #1=10)
(expect: #2=0.5)
(expect: #3=3)
(expect: #4=-0.1)
G10L10P5R10.
G10L11P5R0.5
G10L12P5R3.
G10L13P5R-0.1
#1=#11005
#2=#10005
#3=#13005
#4=#12005
M30
%
