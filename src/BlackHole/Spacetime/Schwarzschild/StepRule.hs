-- | The parameters of the leapfrog integration, with the step rule of the design report
-- (Will Yager, "Accurately Rendering a Black Hole").
module BlackHole.Spacetime.Schwarzschild.StepRule
  ( Leapfrog (..),
    defaultLeapfrog,
    StepRule (..),
    reportStepRule,
    stepLength,
    withStepLength,
  )
where

import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The parameters of the integration.
data Leapfrog = Leapfrog
  { leapfrogSteps :: !StepRule,
    -- | Radius of the celestial sphere, beyond which gravity no longer matters.
    leapfrogSkyRadius :: !Double,
    -- | Number of steps after which a path is given up.
    leapfrogStepLimit :: !Int
  }
  deriving (Eq, Show)

-- | The report's steps, its celestial sphere at 2000 Schwarzschild radii, and a limit
-- that only paths trapped at the photon sphere reach.
defaultLeapfrog :: Leapfrog
defaultLeapfrog =
  Leapfrog
    { leapfrogSteps = reportStepRule,
      leapfrogSkyRadius = 2000,
      leapfrogStepLimit = 200000
    }

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
