module BlackHole.Trace.GasFieldSpec (spec) where

import BlackHole.Matter.GasMotion (keplerianRate)
import BlackHole.Scene.Disk
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.GasField
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Support.Approx
import Test.Hspec

spec :: Spec
spec = do
  describe "spiral arms" $ do
    it "turn with the gas, from +z towards +x, at the rate of the orbit half way out" $
      turnsWith plainArms
    it "take the noise that displaces them along" $
      turnsWith plainArms {diskArmNoise = 3, diskArmNoiseFrequency = 0.5, diskArmNoiseOctaves = 2}
    it "are displaced by noise" $
      spread
        ( zipWith
            (-)
            (map (density plainArms {diskArmNoise = 3, diskArmNoiseFrequency = 0.5}) (places 6 0.2))
            (map (density plainArms) (places 6 0.2))
        )
        `shouldSatisfy` (> 0.01)
    it "are as many as the disk says" $
      sequence_
        [ seen (at 6 (turn + 1 / fromIntegral n) 0.2) `shouldBeWithin` (1e-6, seen (at 6 turn 0.2))
          | n <- [1, 2, 3],
            let seen = density plainArms {diskArms = n},
            turn <- turns
        ]
    it "wind as the disk says: an arm's angle falls by the winding for each unit of radius" $
      sequence_
        [ thinness 7 (turn - 1.1 / (2 * 2 * pi)) `shouldBeWithin` (1e-3, thinness 6 turn)
          | turn <- turns
        ]
  describe "turbulence" $ do
    it "goes round with the gas at every radius" $
      sequence_
        [ do
            correlation
              (map (density turbulent) (ring r 0))
              (map (density turbulent {diskTime = time}) (ring r (rate r * time)))
              `shouldSatisfy` (> 0.9)
            correlation
              (map (density turbulent) (ring r 0))
              (map (density turbulent {diskTime = time}) (ring r (negate (rate r * time))))
              `shouldSatisfy` (< 0.6)
          | let time = 0.1 * life,
            r <- [3.5, 5, 8]
        ]
    it "changes without a jump, also where one pattern gives way to the next" $
      sequence_
        [ afterwards p `shouldBeWithin` (1e-3, before' p)
          | lives <- map (* 0.25) [1 .. 12],
            let afterwards = density turbulent {diskTime = (lives + 1e-7) * life}
                before' = density turbulent {diskTime = (lives - 1e-7) * life},
            p <- take 6 (places 5 0.05)
        ]
    it "is another one after each life" $
      sequence_
        [ abs
            ( correlation
                (map (density turbulent {diskTime = n * life}) (places 5 0))
                (map (density turbulent) (places 5 0))
            )
            `shouldSatisfy` (< 0.5)
          | n <- [1, 2, 3]
        ]
    it "varies as much between two patterns as within one" $
      meanSpread [0.25, 0.75 .. 3.75] / meanSpread [0 .. 3]
        `shouldSatisfy` (\ratio -> ratio > 0.85 && ratio < 1.18)
    it "loses what a long segment cannot resolve, but not its mean" $ do
      spread (map (smeared 2) (places 6 0))
        `shouldSatisfy` (< 0.9 * spread (map (density turbulent) (places 6 0)))
      let mean len = sum [exp (smeared len p) | r <- [4, 4.25 .. 9], p <- places r 0] / (64 * 21)
      (mean 2 / mean 1e-3) `shouldSatisfy` (\ratio -> ratio > 0.8 && ratio < 1.25)
  describe "without arms and turbulence" $ do
    it "falls off like a Gaussian with the height" $
      sequence_
        [ calm (at r 0.3 y)
            `shouldBeWithin` (1e-3, calm (at r 0.3 0) - (y / diskThicknessAt smooth r) ^ (2 :: Int))
          | r <- [5, 8],
            y <- [0.05, -0.1]
        ]
    it "is half as dense at the inner edge, and nothing beyond the outer one" $ do
      calm (at 3 0 0) `shouldBeWithin` (1e-2, log 0.5)
      calm (at 16 0 0) `shouldSatisfy` (< faintest)
    it "does not change with time" $
      density smooth {diskTime = 77} (at 6 0.1 0.05) `shouldBe` calm (at 6 0.1 0.05)
  where
    -- Under a rotation by the arms' own angle nothing changes.
    turnsWith disk =
      sequence_
        [ later (at 6 (turn + rate (sqrt (3 * 16)) * time) 0.2)
            `shouldBeWithin` (1e-6, now (at 6 turn 0.2))
          | let now = density disk,
            time <- [3, 40],
            let later = density disk {diskTime = time},
            turn <- turns
        ]
    turns = [0, 0.13 .. 0.95]
    -- The arms' wave without the flare: what they take from the height's part.
    thinness r turn =
      sqrt
        ( (calm (at r turn 0) - armed (at r turn 0.2))
            / (0.2 / diskThicknessAt smooth r) ^ (2 :: Int)
        )
    meanSpread lives =
      sum
        [ spread
            (map (density turbulent {diskTime = n * life}) (concatMap (`places` 0) [4, 4.5 .. 9]))
          | n <- lives
        ]
        / fromIntegral (length lives)
    smeared len place = along turbulentField place len
    ring r shift = [at r (shift + fromIntegral k / 64) 0 | k <- [0 .. 63 :: Int]]
    places r y = [at r (fromIntegral k / 64) y | k <- [0 .. 63 :: Int]]

-- | Logarithm of the density, as finely as it goes.
-- Made for a disk once if that is the only argument.
density :: Disk -> XYZ -> Double
density disk = \place -> along field place 1e-3
  where
    field = fieldOf disk

along :: GasField -> XYZ -> Double -> Double
along field place len = case gasAt field place (XYZ.norm place) len of
  Here dense _ -> if dense > 0 then log dense else 2 * faintest

-- | Fields that many examples share.
turbulentField :: GasField
turbulentField = fieldOf turbulent

calm, armed :: XYZ -> Double
calm = density smooth
armed = density plainArms

fieldOf :: Disk -> GasField
fieldOf = gasField Schwarzschild 7

-- | The place at a distance from the hole and an angle in turns from +z to +x, at
-- a height.
at :: Double -> Double -> Double -> XYZ
at r turn y = XYZ (rho * sin (2 * pi * turn)) y (rho * cos (2 * pi * turn))
  where
    rho = sqrt (r * r - y * y)

-- | Turns of the gas per unit of time.
rate :: Double -> Double
rate r = keplerianRate r / (2 * pi)

-- | The time for which a pattern of turbulence lives.
life :: Double
life = 1 / rate 3

smooth, plainArms, turbulent :: Disk
smooth =
  reportDisk
    { diskInnerRadius = 3,
      diskOuterRadius = 16,
      diskThickness = 0.35,
      diskProfile = ConstantOpening,
      diskArms = 0,
      diskTurbulence = 0
    }
plainArms = smooth {diskArms = 2, diskArmWinding = 1.1, diskArmDepth = 0.3, diskArmNoise = 0}
turbulent =
  smooth
    { diskTurbulence = 1,
      diskTurbulenceFrequency = 4,
      diskTurbulenceOctaves = 3,
      diskTurbulenceWarp = 0
    }

-- | The standard deviation.
spread :: [Double] -> Double
spread values = sqrt (sum [(v - mean) ^ (2 :: Int) | v <- values] / n)
  where
    n = fromIntegral (length values)
    mean = sum values / n

correlation :: [Double] -> [Double] -> Double
correlation as bs = sum (zipWith (*) (centred as) (centred bs)) / (n * spread as * spread bs)
  where
    n = fromIntegral (length as)
    centred values = map (subtract (sum values / n)) values
