{-# LANGUAGE BangPatterns #-}

-- | Leapfrog integration of light in pseudo-space with the step rule of the
-- design report.
--
-- A step is drift–kick–drift: half a step straight on, the whole kick at the
-- middle, half a step straight on. It is second order (the error falls
-- fourfold when the step is halved) and reversible for steps of one length;
-- drift-then-kick with whole steps would be first order. The middle of the
-- step, where the acceleration is evaluated, is also where the gas is sampled.
module BlackHole.Physics.Leapfrog
  ( StepRule (..),
    reportStepRule,
    stepLength,
    leapfrogStep,
    Leapfrog (..),
    defaultLeapfrog,
    followLeapfrog,
  )
where

import BlackHole.Physics.Fate (Fate (..))
import BlackHole.Physics.LightPath
import BlackHole.Physics.Photon
import BlackHole.Physics.Spacetime (Spacetime, pullOfGravity)
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | How long the next step is, in Schwarzschild radii of pseudo-space.
data StepRule
  = -- | The report's: @l₀ · min(s_bh, s_ad)@ with
    -- @s_bh = 1/(1+e^{10(1.4−r)})@ and @s_ad = 1/(1+e^{10(0.4−|y|/(20 w_ad))})@,
    -- and 10 beyond @r = 40@. The fields are @l₀@ and @w_ad@.
    ReportSteps !Double !Double
  | -- | Every step of this length.
    EqualSteps !Double
  deriving (Eq, Show)

-- | The report's rule with its own numbers: @l₀ = 0.1@, @w_ad = 0.01@.
reportStepRule :: StepRule
reportStepRule = ReportSteps 0.1 0.01

-- | The length of the step that starts at this point.
stepLength :: StepRule -> XYZ -> Double
stepLength rule x = stepLengthAt rule (XYZ.normSquared x) x
{-# INLINE stepLength #-}

-- | The same, for who knows the squared distance from the hole.
stepLengthAt :: StepRule -> Double -> XYZ -> Double
stepLengthAt (EqualSteps l) _ _ = l
stepLengthAt (ReportSteps l0 w) r2 (XYZ _ y _)
  | r2 > 1600 = 10
  -- Most steps end here: with both exponents below −37, 1 + e^exponent is 1 to
  -- the last bit, and neither root nor exponential is needed to know it.
  | r2 > 26.1 && diskExponent < -37 = l0
  | otherwise = l0 / (1 + exp (max (10 * (1.4 - sqrt r2)) diskExponent))
  where
    -- A logistic curve is monotone, so the smaller of the two belongs to the
    -- larger exponent: one exponential instead of two.
    diskExponent = 10 * (0.4 - abs y / (20 * w))
{-# INLINE stepLengthAt #-}

-- | One step of the given pseudo-time. The second argument is the squared
-- angular momentum @h²@, which the caller knows since it never changes.
leapfrogStep :: Spacetime -> Double -> Double -> Photon -> Photon
leapfrogStep spacetime h2 dt photon =
  Photon (middle ^+^ (0.5 * dt) *^ v) v
  where
    (middle, v) = driftAndKick (pullOfGravity spacetime * h2) dt photon
{-# INLINE leapfrogStep #-}

-- | The first half of a step: the middle point and the velocity behind it.
driftAndKick :: Double -> Double -> Photon -> (XYZ, XYZ)
driftAndKick pull dt (Photon x v) = (middle, v ^+^ kick *^ middle)
  where
    middle = x ^+^ (0.5 * dt) *^ v
    r2 = XYZ.normSquared middle
    kick = negate (pull * dt) / (r2 * r2 * sqrt r2)
{-# INLINE driftAndKick #-}

-- | Everything the integration can be told.
data Leapfrog = Leapfrog
  { leapfrogSteps :: !StepRule,
    -- | Radius of the celestial sphere, where gravity no longer matters.
    leapfrogSkyRadius :: !Double,
    -- | Steps after which a path is given up.
    leapfrogStepLimit :: !Int
  }
  deriving (Eq, Show)

-- | The report's steps, its celestial sphere at 2000 Schwarzschild radii, and
-- a limit that only paths caught at the photon sphere ever reach.
defaultLeapfrog :: Leapfrog
defaultLeapfrog =
  Leapfrog
    { leapfrogSteps = reportStepRule,
      leapfrogSkyRadius = 2000,
      leapfrogStepLimit = 200000
    }

-- | Follow a photon of unit energy ('withUnitEnergy') step by step until it is
-- captured (inward at @r ≤ 1@), escapes (outward beyond the celestial sphere),
-- is hidden, or runs out of steps. Only stretches with their middle in the
-- region reach the gatherer. Linear in the number of steps, which does not
-- exceed the limit; nothing is allocated per step.
followLeapfrog ::
  Leapfrog ->
  Spacetime ->
  Region ->
  Photon ->
  (a -> Stretch -> Onward a) ->
  a ->
  Followed a
followLeapfrog (Leapfrog rule skyRadius limit) spacetime region start gather =
  go 0 (photonPosition start) (photonVelocity start)
  where
    !pull = pullOfGravity spacetime * XYZ.normSquared (angularMomentum start)
    !sky2 = skyRadius * skyRadius
    go !n !x !v !state
      | r2 <= 1 && radial < 0 = Followed Captured state n
      | r2 > sky2 && radial > 0 = escaped
      | n >= limit = Followed StepLimit state n
      | insideRegion region middle =
        case gather state (Stretch middle (0.5 *^ (v ^+^ v')) dt) of
          Onward state' -> go (n + 1) x' v' state'
          Hidden state' -> Followed Opaque state' (n + 1)
      | otherwise = go (n + 1) x' v' state
      where
        r2 = XYZ.normSquared x
        radial = XYZ.dot x v
        dt = stepLengthAt rule r2 x / XYZ.norm v
        (middle, v') = driftAndKick pull dt (Photon x v)
        x' = middle ^+^ (0.5 * dt) *^ v'
        escaped = case XYZ.normalize v of
          Just direction -> Followed (Escaped direction) state n
          -- Only a photon that never had a direction gets here.
          Nothing -> Followed StepLimit state n
{-# INLINE followLeapfrog #-}
