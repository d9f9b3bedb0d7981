-- | The landmark radii of a Schwarzschild black hole, in units of the
-- Schwarzschild radius (@r_s = 2M = 1@).
module BlackHole.Physics.Radii
  ( horizonRadius,
    photonSphereRadius,
    marginallyBoundRadius,
    iscoRadius,
    criticalImpactParameter,
  )
where

-- | The event horizon.
horizonRadius :: Double
horizonRadius = 1

-- | The photon sphere: light can circle here, unstably.
photonSphereRadius :: Double
photonSphereRadius = 1.5

-- | The marginally bound circular orbit of matter: its energy equals its rest
-- mass.
marginallyBoundRadius :: Double
marginallyBoundRadius = 2

-- | The innermost stable circular orbit of matter.
iscoRadius :: Double
iscoRadius = 3

-- | @3√3\/2@: light coming in from infinity falls into the hole exactly when
-- its impact parameter is smaller. The nearest 'Double' lies 7.2e-17 above the
-- true value.
criticalImpactParameter :: Double
criticalImpactParameter = 2.598076211353316
