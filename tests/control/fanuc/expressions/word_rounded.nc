%
O0001
(rule: F 12 a computed word is rounded to the increment, half away)
(expect: to X1.235 Y0)
(expect: to X1.235 Y12.345)
(expect: to X-1.235)
#1=1.2345
G00X#1
Y[#1*10]
X-#1
M30
%
