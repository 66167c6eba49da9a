%
O0001
(rule: F 6.6 names of what the control knows, and numbers of 6.5)
(expect: #101=0)
(expect: #102=0)
(expect: #104=0)
(expect: #105=0)
(expect: #106=0)
(expect: #108=500)
(expect: #109=3)
(expect: #112=250)
(expect: #115=500)
(expect: #116=3)
(expect: #118=0)
(expect: #119=0)
(expect: #120=0)
(expect: #121=0)
(expect: #122=98)
(expect: #123=97)
(expect: #127=500)
(expect: #128=3)
(expect: #130=0)
(expect: #131=0)
(expect: #132=0)
(expect: #190=0)
G21 G90 G54
T3 M06
S500 M03 F250
G01 X10.
#100=[#_CLOCK2]
#101=[#_CNTL2]
#102=[#_MRIMG]
#103=[#_TIME]
#104=[#_PRTSN]
#105=[#_BUFD]
#106=[#_BUFH]
#107=[#_BUFN]
#108=[#_BUFS]
#109=[#_BUFT]
#110=[#_BUFWZP]
#111=[#_ACTD]
#112=[#_ACTF]
#113=[#_ACTH]
#114=[#_ACTN]
#115=[#_ACTS]
#116=[#_ACTT]
#117=[#_ACTWZP]
#118=[#_TOFS[1]]
#119=[#_MIRTP[1]]
#120=[#_DIST[1]]
#121=#3008
#122=#4210
#123=#4213
#124=#4307
#125=#4311
#126=#4314
#127=#4319
#128=#4320
#129=#4330
#130=#5121
#131=#100201
#132=#100301
#133=#100651
#190=#100801
M30
%
