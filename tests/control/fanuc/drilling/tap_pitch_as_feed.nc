%
O0001
(rule: F 5.1 under G94 F of a tapping cycle is pitch times speed: a pitch of 0.0125 mm was none)
(expect: warning K5905 at 9:15)
(expect: warning K5905 at 11:5)
(expect: path X10 Z2 z-6f0.0125 z2 Z0 X15 Z2 z-6f1.25 z2 Z0 X20 Z2 z-6f0.01 z2 Z0)
T1M06
G94S100M03
G84X10.Z-6.R2.F1.25
X15.F125.
X20.F1.
G80
M30
%
