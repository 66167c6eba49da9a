%
;rule: NC-210 11: a word takes one E parameter, with or without blanks beside it
;expect: path X12Y-3 z-5f200
;expect: E30=12
S1000 M3
G94
E30=12.
E31=-3
E32=E31-2
E25=200
G0 XE30 YE31
G1 ZE32 FE25
M30
