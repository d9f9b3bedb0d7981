-- | The characteristic radii of a Schwarzschild black hole, in Schwarzschild radii
-- (@r_s = 2M = 1@).
module BlackHole.Spacetime.Schwarzschild.Radii
  ( horizonRadius,
    photonSphereRadius,
    iscoRadius,
    criticalImpactParameter,
  )
where

-- | The event horizon.
horizonRadius :: Double
horizonRadius = 1

-- | The photon sphere, on which light can circle, unstably.
photonSphereRadius :: Double
photonSphereRadius = 1.5

-- | The innermost stable circular orbit of matter.
iscoRadius :: Double
iscoRadius = 3

-- | @3√3\/2@: light from infinity falls into the hole exactly if its impact parameter
-- is smaller. The nearest 'Double' is 7.2e-17 above the true value.
criticalImpactParameter :: Double
criticalImpactParameter = 2.598076211353316
