// wend.xcs, wend.lcs, wend.zcs: classifier systems over one store of ternary rules.
//   S. W. Wilson: Classifier fitness based on accuracy, Evolutionary Computation 3 (1995) 149-175;
//   M. V. Butz, S. W. Wilson: An algorithmic description of XCS, Soft Computing 6 (2002) 144-153;
//   S. W. Wilson: ZCS, a zeroth level classifier system, Evolutionary Computation 2 (1994) 1-18.
// wend.lcs is wend.xcs with the operators of the robot-navigation paper by default; see README.md.
//
//   symbol            here                  meaning                                                        equation
//   [P], [M], [A]     Population, RuleSet   all rules; those that match; those of [M] with the action
//   p, epsilon, F     prediction, error,    payoff that a rule predicts, its mean error, its fitness       (1)-(7)
//                     fitness
//   exp, as, ts, num  experience, set_size, how often updated, mean size of its action sets, time of
//                     stamp, numerosity     its last GA, copies it stands for
//   PA(a)             Predictions::array    sum F p / sum F                                                (1)
//   P_target          Experience::target    R + gamma max PA                                               (2)
//   kappa             accuracy()            1 if epsilon < epsilon_0 else alpha (epsilon / epsilon_0)^-nu  (5)
//   '#'               care bit 0            a bit that may be either
//   S                 prediction            ZCS: a rule's strength
#include "xcs_learner.hpp"
#include "zcs_learner.hpp"

WEND_PLUGIN(wend::component<xcs::Xcs>("wend.xcs"), wend::component<xcs::Lcs>("wend.lcs"),
            wend::component<xcs::Zcs>("wend.zcs"))
