module BlackHole.Spacetime.Kerr.WorldLineSpec (spec) where

import BlackHole.Matter.KerrFlow
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.WorldLine
import BlackHole.Spacetime.Schwarzschild.FreeFall
import Data.Maybe (fromMaybe, isNothing)
import Support.Approx
import Support.KerrReference
import Test.Hspec

spec :: Spec
spec = do
  it "are Schwarzschild's without spin" $ do
    kerrInfallTime (spinOf 0) 0.3 10 2 `shouldBeWithin` (1e-10, infallTime 10 2)
    sequence_
      [ fromMaybe 0 (kerrInfallRadius (spinOf 0) 0.3 10 time)
          `shouldBeWithin` (1e-9, fromMaybe 0 (infallRadius 10 time))
        | time <- [-30, 0, 5, 20]
      ]
    kerrOrbitalPhase (spinOf 0) 6 10
      `shouldSatisfy` maybe False (\phase -> abs (phase - fromMaybe 0 (orbitalPhase 6 10)) < 1e-13)
  it "fall at the rate of the geodesic equation" $ do
    -- dr/dτ = −√(r (r² + a²)) / Σ, by a difference.
    let hole = spinOf 0.9
        a2 = spinLength hole * spinLength hole
        slope r = -sqrt (r * (r * r + a2)) / (r * r + a2 * 0.25)
    sequence_
      [ (-2e-4 / kerrInfallTime hole 0.5 (r + 1e-4) (r - 1e-4)) `shouldBeWithin` (1e-6, slope r)
        | r <- [0.4, 1, 3, 20]
      ]
  it "find the radius of a time, and end at the centre" $ do
    let hole = spinOf (-0.7)
    sequence_
      [ fmap (kerrInfallTime hole 0 8) (kerrInfallRadius hole 0 8 time)
          `shouldSatisfy` maybe False (\t -> abs (t - time) < 1e-9)
        | time <- [-5, 0.1, 3, 14]
      ]
    kerrInfallRadius hole 0 8 1000 `shouldSatisfy` isNothing
  it "circle at the rate of the gas, slowed by its clock, outside the photon orbit only" $ do
    let hole = spinOf 0.9
        r = 4
        a = spinLength hole
        -- u^t of the circular geodesic (Bardeen, Press and Teukolsky 1972).
        timeRate =
          (sqrt 2 * r ** 1.5 + a) / sqrt (2 * r ** 3 - 3 * r * r + 2 * sqrt 2 * a * r ** 1.5)
    fromMaybe 0 (kerrOrbitalPhase hole r 1)
      `shouldBeWithin` (1e-13, timeRate * kerrOrbitalRate (kerrFlow hole) r)
    kerrOrbitalPhase hole (photonOrbitRadius RightHanded hole) 1 `shouldSatisfy` isNothing
