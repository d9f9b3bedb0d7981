-- | The frequency shift of light from the gas to the observer, g = ν_obs/ν_em. A black
-- body of temperature T appears as one of temperature g T, and its bolometric intensity is
-- multiplied by g⁴.
module BlackHole.Matter.Redshift
  ( Redshift (..),
    redshift,
    crossingRedshift,
  )
where

import BlackHole.Matter.GasFlow
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Observer (SightLine, sightFrequency)
import BlackHole.Spacetime.PlaneCrossing

-- | g, above 1 for a blueshift, and its two factors.
data Redshift = Redshift
  { redshiftFactor :: {-# UNPACK #-} !Double,
    -- | g of gas at rest at the same place (around a rotating hole, of gas without angular
    -- momentum): the gravitational factor, together with any motion of the observer.
    redshiftGravitational :: {-# UNPACK #-} !Double,
    -- | The Doppler factor of the gas relative to an observer at rest beside it; below
    -- 1 also for motion across the line of sight.
    redshiftDoppler :: {-# UNPACK #-} !Double
  }
  deriving (Eq, Show)

-- | The shift from the observer's ν_obs/E∞ and the frequencies at the gas.
redshift :: Double -> Frequencies -> Redshift
redshift observed (Frequencies inGas beside) =
  Redshift (observed / inGas) (observed / beside) (beside / inGas)

-- | The shift of light that gas at a crossing sends along a line of sight. 'Nothing' at
-- and inside the horizon.
crossingRedshift :: GasFlow -> SightLine -> PlaneCrossing (Maybe Momentum) -> Maybe Redshift
crossingRedshift flow sight crossing =
  redshift (sightFrequency sight) <$> crossingFrequencies flow sight crossing
