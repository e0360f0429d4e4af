; The facts of machine arithmetic that contracts/raster/types.h.acsl takes as axioms, for all numbers
; of 64 bits. Each query denies one of them; each answer must be "unsat".
(set-logic QF_BV)
(declare-const n (_ BitVec 64))

; shift_rounds_down: n - 256 * (n >> 8) is 0 to 255.
(push)
(assert (not (bvult (bvsub n (bvshl (bvashr n #x0000000000000008) #x0000000000000008))
                    #x0000000000000100)))
(check-sat)
(pop)

; shift_rounds_down: 256 * (n >> 8) does not overflow.
(push)
(assert (not (= (bvashr n #x0000000000000008)
                (bvashr (bvshl (bvashr n #x0000000000000008) #x0000000000000008)
                        #x0000000000000008))))
(check-sat)
(pop)

; wraps_up: (uint32_t)n is n + 2^32 for n from -2^32 to -1.
(push)
(assert (bvsle #xFFFFFFFF00000000 n))
(assert (bvslt n #x0000000000000000))
(assert (not (= ((_ zero_extend 32) ((_ extract 31 0) n)) (bvadd n #x0000000100000000))))
(check-sat)
(pop)
