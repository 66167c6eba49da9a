%
O0001
(rule: F 6.5 inputs #1000 to #1035, outputs #1100 to #1135; cases/fanuc.md 9, 14: 0 and one warning)
(expect: #100=0)
(expect: #101=0)
(expect: #102=9)
(expect: #103=5)
(expect: #104=0)
(expect: #105=0)
(expect: #106=0)
(expect: #107=1)
(expect: #108=0)
(expect: warning K5950 at 20:6)
(expect: warning K5950 at 22:9)
(expect: warning K5950 at 26:6)
(expect: warning K5950 at 27:6)
(expect: warning K5950 at 28:6)
(expect: warning K5950 at 30:6)
#5=1000
#100=#[#5+4]
#101=#1004
#1133=5+#1033
#1132=9
#102=#1132
#103=#1133
#104=#5101
#105=#3005
#106=#100251
#107=#1103
#108=#1032
M30
%
