%
O0001
(rule: F 6.4 rounded words add up)
(expect: to X-1.235)
(expect: to X-3.581)
(expect: to X-0.001)
#1=1.2345
#2=2.3456
S1000 M03
G91G01X-#1F100.
X-#2
X[#1+#2]
M30
%
