%
O0001
(rule: F 3.4 G10 L1: what L11 is; controls with memory A and programs of older ones say it)
(expect: #1=-0.2)
(expect: #2=-0.15)
G10L10P3R50.
G10L1P3R-0.2
#1=#10003
G91G10L1P3R0.05
#2=#10003
G90
M30
%
