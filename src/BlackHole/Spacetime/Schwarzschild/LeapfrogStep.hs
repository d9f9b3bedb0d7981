-- | One step of the leapfrog integration of light in pseudo-space, with the step rule of
-- the design report (Will Yager, "Accurately Rendering a Black Hole").
--
-- A step is drift–kick–drift: half a step straight on, the whole kick at the middle,
-- half a step straight on. The method is second order (halving the step divides the
-- error by four) and, for steps of equal length, reversible. Drift and kick in whole
-- steps would be first order. The gas is sampled at the middle of the step, where the
-- acceleration is evaluated.
module BlackHole.Spacetime.Schwarzschild.LeapfrogStep
  ( StepRule (..),
    reportStepRule,
    stepLength,
    withStepLength,
    leapfrogStep,
  )
where

import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types (Spacetime, pullOfGravity)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The rule for the length of the next step, in Schwarzschild radii of pseudo-space.
data StepRule
  = -- | The report's rule: @l₀ · min(s_bh, s_ad)@ with @s_bh = 1/(1+e^{10(1.4−r)})@ and
    -- @s_ad = 1/(1+e^{10(0.4−|y|/(20 w_ad))})@, and 10 beyond @r = 40@. The fields are
    -- @l₀@ and @w_ad@.
    ReportSteps {-# UNPACK #-} !Double {-# UNPACK #-} !Double
  | -- | Steps of equal length.
    EqualSteps {-# UNPACK #-} !Double
  deriving (Eq, Show)

-- | The report's rule with its own constants, @l₀ = 0.1@ and @w_ad = 0.01@.
reportStepRule :: StepRule
reportStepRule = ReportSteps 0.1 0.01

-- | The length of the step that starts at this point, in Schwarzschild radii.
stepLength :: StepRule -> XYZ -> Double
stepLength rule x@(XYZ _ y _) = stepLengthAt rule (XYZ.normSquared x) y
{-# INLINE stepLength #-}

-- | The length of a step from the squared distance to the hole and the height.
stepLengthAt :: StepRule -> Double -> Double -> Double
stepLengthAt (EqualSteps l) = \_ _ -> l
stepLengthAt (ReportSteps l0 w) = reportLength l0 w
{-# INLINE stepLengthAt #-}

reportLength :: Double -> Double -> Double -> Double -> Double
reportLength l0 w r2 y
  | r2 > 1600 = 10
  -- Most steps end here: with both exponents below −37, 1 + e^exponent is 1 to the last
  -- bit, so neither the root nor the exponential is needed.
  | r2 > 26.1 && abs y > 82.1 * w = l0
  | otherwise = l0 / (1 + exp (max (10 * (1.4 - sqrt r2)) diskExponent))
  where
    -- A logistic curve is monotone, so the smaller of the two belongs to the
    -- larger exponent: one exponential instead of two.
    diskExponent = 10 * (0.4 - abs y / (20 * w))
{-# INLINE reportLength #-}

-- | Passes the rule's length on as a function, chosen once. Choosing inside the loop
-- would make GHC spill the whole state of the loop at every turn.
withStepLength :: StepRule -> ((Double -> Double -> Double) -> b) -> b
withStepLength (EqualSteps l) use = use (\_ _ -> l)
withStepLength (ReportSteps l0 w) use = use (reportLength l0 w)
{-# INLINE withStepLength #-}

-- | @leapfrogStep spacetime h2 dt photon@ is the photon after one step of the
-- pseudo-time @dt@. @h2@ is its squared angular momentum, which the caller knows
-- because it never changes.
leapfrogStep :: Spacetime -> Double -> Double -> Photon -> Photon
leapfrogStep spacetime h2 dt photon =
  Photon (middle ^+^ (0.5 * dt) *^ v) v
  where
    (middle, v) = driftAndKick (pullOfGravity spacetime * h2) dt photon
{-# INLINE leapfrogStep #-}

-- | The first half of a step: the middle point, and the velocity after the kick.
driftAndKick :: Double -> Double -> Photon -> (XYZ, XYZ)
driftAndKick pull dt (Photon x v) = (middle, v ^+^ kick *^ middle)
  where
    middle = x ^+^ (0.5 * dt) *^ v
    r2 = XYZ.normSquared middle
    kick = negate (pull * dt) / (r2 * r2 * sqrt r2)
{-# INLINE driftAndKick #-}
