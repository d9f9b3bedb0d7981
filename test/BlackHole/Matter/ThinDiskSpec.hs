module BlackHole.Matter.ThinDiskSpec (spec) where

import BlackHole.Matter.ThinDisk
import BlackHole.Spacetime.Kerr.Landmarks
import Support.Approx
import Support.KerrReference
import Test.Hspec

spec :: Spec
spec = do
  describe "without spin, the flux" $ do
    it "is 0 at the innermost stable orbit, inside it and for no number" $
      map flux [3, 2.999, 1.5, 1, 0, -1, 0 / 0, 1 / 0]
        `shouldBe` replicate 8 0
    it "has the values of 40-digit arithmetic, down to the edge" $
      mapM_
        ( \(r, known) ->
            (r, flux r) `shouldSatisfy` (near 5e-15 known . snd)
        )
        fortyDigits
    it "vanishes as the square of the distance to the edge" $ do
      let step = 1 / 1048576
      flux (3 + 2 * step) / flux (3 + step)
        `shouldSatisfy` near 1e-5 4
    it "is the integral of conservation laws (Page and Thorne, eq. 15)" $
      mapM_
        ( \r ->
            (r, flux r)
              `shouldSatisfy` (near 1e-9 (fluxOfConservation r) . snd)
        )
        [3.05, 3.5, 4, 4.7755, 6, 10, 30]
    it "would not be with the misprinted factor √3/3" $
      mapM_
        ( \r ->
            (r, misprint r)
              `shouldSatisfy` (not . near 0.1 (fluxOfConservation r) . snd)
        )
        [3.5, 4.7755, 10]
    it "falls as 1/(8r³) far out" $
      flux 1e12 * 8e36 `shouldSatisfy` near 1e-5 1
    it "stays finite at the largest radii" $
      map flux [1e60, 1e300] `shouldSatisfy` all (\f -> f >= 0 && f < 1e-100)

  describe "without spin, the peak" $ do
    it "is 4.7755" $ peakRadius `shouldSatisfy` (\r -> abs (r - 4.7755) < 5e-5)
    it "is where the flux turns, to a part in 1e5" $ do
      let slopeAt r = flux (r + 1e-6) - flux (r - 1e-6)
      (slopeAt (peakRadius - 5e-5), slopeAt (peakRadius + 5e-5))
        `shouldSatisfy` (\(rising, falling) -> rising > 0 && falling < 0)
    it "solves the equation of the maximum to double precision" $ do
      -- d ln F/dx = 0 with dF's bracket f: f' = (x²−6)/(x²−3), hence
      -- f = (x²−6) x / (2x² + 5(x²−3)), free of cancellation.
      let residual r =
            let x2 = 2 * r
                x = sqrt x2
             in flux r * (x2 - 3) * x2 * x2 * x
                  - (x2 - 6) * x / (2 * x2 + 5 * (x2 - 3))
      (residual (peakRadius - 1e-13), residual (peakRadius + 1e-13))
        `shouldSatisfy` (\(below, above) -> signum below /= signum above)
    it "has the flux of 40-digit arithmetic" $
      snd (thinDiskPeak disk) `shouldSatisfy` near 1e-14 1.1458947324417218e-4

  describe "without spin, the temperature" $ do
    it "is 1 at the peak and nowhere more" $ do
      temperature peakRadius `shouldSatisfy` near 1e-14 1
      map temperature [2.9, 2.95 .. 50] `shouldSatisfy` all (\t -> t >= 0 && t <= 1)
    it "has the values of 40-digit arithmetic" $
      map temperature [3.25, 4, 100]
        `shouldSatisfy` and
          . zipWith
            (near 1e-13)
            [0.64470649860504027, 0.9564693307028039, 0.16884770387863296]
    it "falls as r^(-3/4) far out" $
      temperature 1.6e13 / temperature 1e12
        `shouldSatisfy` near 1e-5 0.125

  describe "with spin" $ do
    it "has the flux of 40 digits, down to the edge, and its peak" $ do
      rows <- kerrRows "kerr-flux.csv"
      length rows `shouldSatisfy` (> 30)
      sequence_
        [ do
            thinDiskFlux spinning r `shouldBeWithin` (1e-11 * read known, read known)
            (thinDiskFlux spinning r / snd (thinDiskPeak spinning))
              `shouldBeWithin` (1e-11 * read relative, read relative)
            if kind == "peak"
              then fst (thinDiskPeak spinning) `shouldBeWithin` (1e-13 * r, r)
              else pure ()
          | [s, _, kind, radius, known, relative] <- rows,
            let spinning = thinDisk (spinOf (read s))
                r = read radius
        ]
    it "goes over into that without spin for slow holes" $
      sequence_
        [ thinDiskFlux (thinDisk (spinOf s)) 6 `shouldBeWithin` (1e-3 * abs s, flux 6)
          | s <- [1e-3, -1e-6, 1e-9, -1e-12]
        ]
    it "does not shine at and inside the innermost stable orbit, nor at infinity" $
      sequence_
        [ thinDiskFlux (thinDisk (spinOf s)) r `shouldBe` 0
          | s <- [-0.9, 0, 0.9, 0.9999],
            r <- [0, 0.5, iscoRadius RightHanded (spinOf s), 1 / 0, 0 / 0]
        ]
    it "falls off as 1/(8r³)" $
      sequence_
        [ (thinDiskFlux (thinDisk (spinOf s)) 1e12 * 8e36) `shouldBeWithin` (1e-5, 1)
          | s <- [-0.9, 0, 0.998]
        ]
    it "is hottest at the peak" $ do
      let spinning = thinDisk (spinOf 0.9)
          peak = fst (thinDiskPeak spinning)
      relativeTemperature spinning peak `shouldBeWithin` (1e-15, 1)
      map (relativeTemperature spinning) [0.9 * peak, 1.1 * peak, 0.7 * peak]
        `shouldSatisfy` all (< 1)
  where
    disk = thinDisk noSpin
    flux = thinDiskFlux disk
    peakRadius = fst (thinDiskPeak disk)
    temperature = relativeTemperature disk
    near limit expected value = abs (value - expected) <= limit * abs (expected :: Double)
    fortyDigits =
      [ (3 + 1 / 1048576, 4.6784615167945198e-16),
        (3 + 1 / 1024, 4.895896655613186e-10),
        (3.0625, 1.7705464559833167e-6),
        (3.25, 1.9796705141694614e-5),
        (4, 9.5902276967396365e-5),
        (6, 9.7885414715052767e-5),
        (100, 9.3137667958433957e-8),
        (1048576, 1.0812284696526654e-19)
      ]

-- | F = (Ṁ/4πr) (−Ω')/(E−ΩL)² ∫ (E−ΩL) L' dr from r = 3, in the unit of
-- 'flux', from the circular orbits alone.
fluxOfConservation :: Double -> Double
fluxOfConservation r =
  negate (derivative omega r) / (coupling r * coupling r * r * 4 * pi)
    * integral (\q -> coupling q * derivative angular q) 3 r
    * (2 * pi / 3)
  where
    omega q = 1 / sqrt (2 * q * q * q)
    energy q = (1 - 1 / q) / sqrt (1 - 1.5 / q)
    angular q = sqrt (q / 2) / sqrt (1 - 1.5 / q)
    coupling q = energy q - omega q * angular q
    -- Fourth-order differences.
    derivative f q =
      let h = 1e-3
       in (8 * (f (q + h) - f (q - h)) - (f (q + 2 * h) - f (q - 2 * h))) / (12 * h)

-- | Simpson's rule with 2000 panels.
integral :: (Double -> Double) -> Double -> Double -> Double
integral f from to = h / 3 * sum (zipWith (*) weights (map at [0 .. panels]))
  where
    panels = 2000 :: Int
    h = (to - from) / fromIntegral panels
    at i = f (from + h * fromIntegral i)
    weights = 1 : take (panels - 1) (cycle [4, 2]) ++ [1]

-- | The flux as a classic paper misprints it.
misprint :: Double -> Double
misprint r =
  ( x - sqrt 6
      + sqrt 3 / 3
        * log ((x + sqrt 3) * (sqrt 6 - sqrt 3) / ((x - sqrt 3) * (sqrt 6 + sqrt 3)))
  )
    / ((x * x - 3) * x ^ (5 :: Int))
  where
    x = sqrt (2 * r)
