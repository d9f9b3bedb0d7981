module BlackHole.Trace.GasHeatSpec (spec) where

import BlackHole.Scene.Disk
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.GasField
import BlackHole.Vector.XYZ (XYZ (..))
import Support.Approx
import Test.Hspec

-- | The temperature fluctuations of turbulent gas.
spec :: Spec
spec = do
  describe "the mean of T⁴, and so the flux of a ring, is that of the smooth disk" $ do
    it "with all octaves" $ meanFlux hot 0 `shouldBeWithin` (0.03, 1)
    it "with the octaves that a long segment resolves" $ meanFlux hot 1.2 `shouldBeWithin` (0.03, 1)
    it "while one pattern of turbulence replaces the other" $
      meanFlux hot {diskTime = 11} 0 `shouldBeWithin` (0.03, 1)
    it "with arms" $ meanFlux hot {diskArms = 2, diskArmDepth = 0.4} 0 `shouldBeWithin` (0.03, 1)
  it "the temperature varies, and more with more heat" $ do
    let spread heat = sqrt (meanOf (map (** 2) (heats hot {diskTurbulenceHeat = heat} 0)))
    spread 0.05 `shouldSatisfy` (> 0.02)
    spread 0.1 `shouldSatisfy` (> 1.8 * spread 0.05)
  it "dense gas is hotter than thin gas of the same ring" $ do
    let here =
          [ gasAt (gasField Schwarzschild 1 hot) (place r turn) r 0
            | r <- [6],
              turn <- turns 400
          ]
        dense = [h | Here d h <- here, d > medianOf [d' | Here d' _ <- here]]
        thin = [h | Here d h <- here, d <= medianOf [d' | Here d' _ <- here]]
    minimum dense `shouldSatisfy` (>= maximum thin - 1e-9)
  it "no heat leaves every temperature alone" $
    heats hot {diskTurbulenceHeat = 0} 0 `shouldSatisfy` all (== 0)
  it "the haze is as warm as the mean of its ring" $
    gasAt
      (gasField Schwarzschild 1 hot {diskHaze = 0.01, diskHazeHeight = 4})
      (XYZ 6 0.3 0)
      6
      0
      `shouldSatisfy` \(Here density heat) -> density > 1e-4 && abs heat < 1e-6
  where
    hot =
      defaultDisk
        { diskArms = 0,
          diskHaze = 0,
          diskTime = 0,
          diskTurbulence = 4,
          diskTurbulenceHeat = 0.12
        }

-- | The mean of T⁴ over that of smooth gas, over some seeds, in the disk's plane.
meanFlux :: Disk -> Double -> Double
meanFlux disk len = meanOf (map (\h -> exp (4 * h)) (heats disk len))

heats :: Disk -> Double -> [Double]
heats disk len =
  [ heat
    | seed <- [1 .. 12],
      let field = gasField Schwarzschild seed disk,
      (i, turn) <- zip [0 ..] (turns 1500),
      -- The radii of the noise's whole period.
      let r = 3.5 * exp (2 * fractionOf (0.5698402909980532 * fromIntegral (i :: Int))),
      r < 0.6 * diskOuterRadius disk,
      Here density heat <- [gasAt field (place r turn) r (len * r)],
      density > 0
  ]

place :: Double -> Double -> XYZ
place r turn = XYZ (r * sin (2 * pi * turn)) 0 (r * cos (2 * pi * turn))

turns :: Int -> [Double]
turns count = [fractionOf (0.7548776662466927 * fromIntegral i) | i <- [1 .. count]]

fractionOf :: Double -> Double
fractionOf x = x - fromIntegral (floor x :: Int)

meanOf :: [Double] -> Double
meanOf values = sum values / fromIntegral (length values)

medianOf :: [Double] -> Double
medianOf values =
  foldr
    (\v rest -> if length (filter (<= v) values) * 2 >= length values then min v rest else rest)
    (1 / 0)
    values
