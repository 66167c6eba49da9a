%
O0001
(rule: F 9.3, 9.4 no distance along Z: the zero of a part on a table turned by B)
(expect: #100=500)
(expect: #101=-725)
(expect: to X500 Z-725)
#500=500.
#501=-800.
#502=1.
G10L2P1X425.Y0Z-800.
G65P7101A90.I1.J2.
#100=ROUND[#5241*1000]/1000
#101=ROUND[#5243*1000]/1000
G55
G00X0Y0Z0
M30
O7101
(A angle of the table, measured at 0; I from and J to work offsets 1 to 6)
#11=5201+20*#4
#12=5201+20*#5
#3=#502*#1
#7=#[#11]-#500
#8=#[#11+2]-#501
#[#12]=#500+#7*COS[#3]+#8*SIN[#3]
#[#12+2]=#501-#7*SIN[#3]+#8*COS[#3]
M99
%
