%
O0001
(rule: F 6.5 offsets of a lathe under five digits)
(expect: #1=4)
(expect: #2=7)
(expect: #3=0.4)
(expect: #4=2)
#15001=4.
#16001=6.
#11001=1.
#17001=0.4
#13001=2
#1=#2701
#2=#2801+#2101
#3=#2901
#4=#2301
M30
%
