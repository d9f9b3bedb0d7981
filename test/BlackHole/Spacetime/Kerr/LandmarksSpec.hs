module BlackHole.Spacetime.Kerr.LandmarksSpec (spec) where

import BlackHole.Spacetime.Kerr.Landmarks
import Data.Maybe (isJust)
import Support.Approx
import Support.KerrReference
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "agree with 40-digit root searches on the metric" $ do
    rows <- kerrRows "kerr-radii.csv"
    length rows `shouldBe` 5
    sequence_
      [ value (spinOf (read s)) `shouldBeWithin` (1e-14, read cell)
        | s : cells <- rows,
          (value, cell) <-
            zip
              [ horizonRadius,
                innerHorizonRadius,
                photonOrbitRadius RightHanded,
                photonOrbitRadius LeftHanded,
                (`sphericalOrbitRadius` 0),
                marginallyBoundRadius,
                marginallyBoundRadius . mirror,
                iscoRadius RightHanded,
                iscoRadius LeftHanded
              ]
              cells
      ]
  it "are Schwarzschild's without spin" $
    map
      ($ spinOf 0)
      [ horizonRadius,
        innerHorizonRadius,
        photonOrbitRadius RightHanded,
        (`sphericalOrbitRadius` 0),
        iscoRadius RightHanded,
        (`ergosphereRadius` 0.3)
      ]
      `shouldSatisfy` (all ((< 1e-15) . abs) . zipWith (-) [1, 0, 1.5, 1.5, 3, 1])
  it "exist for spins within (−1, 1) only" $
    map (isJust . spin) [-1, -0.9999, 0, 0.9999, 1, 1.5, 0 / 0]
      `shouldBe` [False, True, True, True, False, False, False]
  prop "lie in their order outside the horizon" $ \(Spinning hole) ->
    counterexample (show hole) $
      let ascending =
            [ innerHorizonRadius hole,
              horizonRadius hole,
              prograde photonOrbitRadius hole,
              prograde iscoRadius hole
            ]
       in and (zipWith (<=) ascending (drop 1 ascending))
  prop "mirror the hole with its spin" $ \(Spinning hole) ->
    let mirrored = spinOf (negate (dimensionlessSpin hole))
     in iscoRadius RightHanded hole === iscoRadius LeftHanded mirrored
          .&&. photonOrbitRadius RightHanded hole === photonOrbitRadius LeftHanded mirrored
  prop "put the innermost stable orbit where the binding energy is greatest" $ \(Spinning hole) ->
    -- dE/dr = 0 with E(r) of the circular orbit, in x = √(2r).
    let s = dimensionlessSpin hole
        x = sqrt (2 * iscoRadius RightHanded hole)
     in counterexample (show (s, x)) (abs (x ** 4 - 6 * x * x + 8 * s * x - 3 * s * s) < 1e-12)
  where
    -- Of the circular orbit whose energy is the rest mass.
    marginallyBoundRadius hole = let s = dimensionlessSpin hole in 0.5 * (2 - s + 2 * sqrt (1 - s))
    mirror = spinOf . negate . dimensionlessSpin
    prograde radius hole =
      radius (if dimensionlessSpin hole < 0 then LeftHanded else RightHanded) hole

-- | Spins from both signs up to 0.9999.
newtype Spinning = Spinning Spin
  deriving (Show)

instance Arbitrary Spinning where
  arbitrary =
    Spinning . spinOf
      <$> oneof [choose (-0.9999, 0.9999), choose (-1e-6, 1e-6), elements [-0.9999, 0.9999, 0]]
