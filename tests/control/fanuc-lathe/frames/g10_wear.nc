%
O0001
(rule: F 3.4 G10 P1 to 64: wear; U, W and C are added)
(expect: #1=-0.06)
(expect: #2=0.1)
(expect: #3=0.02)
G10P3X-0.02Z0.1R0.01
G10P3U-0.04C0.01
#1=#2003
#2=#2103
#3=#2203
M30
%
