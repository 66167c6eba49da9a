%
;rule: NC-210 11: timers and accumulators are values; TMR, ERF and MCD are assigned like variables
;expect: E30=3
TMR=2
ERF=.05
MCD=10
#TIM1=TIM0
TOT2=TIM1+3
E30=TOT2
M30
