; The facts of machine arithmetic that contracts/kernel/raster/raster.h.acsl takes as axioms, for all numbers
; of 64 bits. Each query denies one of them; each answer must be "unsat".
(set-logic QF_FPBV)
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

; A float minus its floor is 0 to 1, or NaN (kernel/texture/wrap.inl, fraction_of).
(declare-const x (_ FloatingPoint 8 24))
(define-fun fraction () (_ FloatingPoint 8 24) (fp.sub RNE x (fp.roundToIntegral RTN x)))
(push)
(assert (not (or (fp.isNaN fraction)
                 (and (fp.leq ((_ to_fp 8 24) RNE 0.0) fraction)
                      (fp.leq fraction ((_ to_fp 8 24) RNE 1.0))))))
(check-sat)
(pop)
