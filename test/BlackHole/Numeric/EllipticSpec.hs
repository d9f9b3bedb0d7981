module BlackHole.Numeric.EllipticSpec (spec) where

import BlackHole.Numeric.Elliptic
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck hiding (within)

-- | Complementary parameters over the whole range, dense at both ends.
newtype Complement = Complement Double deriving (Show)

instance Arbitrary Complement where
  arbitrary =
    Complement
      <$> oneof
        [ choose (0, 1),
          (10 **) <$> choose (-30, 0),
          (\e -> 1 - 10 ** e) <$> choose (-14, 0),
          elements [0.5, 0.49999999, 1]
        ]

-- | An argument as a fraction of the quarter period.
newtype Fraction = Fraction Double deriving (Show)

instance Arbitrary Fraction where
  arbitrary = Fraction <$> choose (-2, 2)

within :: Double -> Double -> Double -> Property
within limit expected actual =
  counterexample
    ("expected " ++ show expected ++ ", got " ++ show actual)
    (abs (actual - expected) <= limit)

-- | Of two numbers, relative to the first.
closeTo :: Double -> Double -> Double -> Property
closeTo limit expected = within (limit * abs expected) expected

spec :: Spec
spec = do
  describe "jacobi" $ do
    prop "has sn² + cn² = 1 and dn² + m sn² = 1" $ \(Complement m1) (Fraction f) ->
      let md = modulus m1
          Jacobi sn cn dn = jacobi md (f * quarterPeriod md)
       in within 4e-15 1 (sn * sn + cn * cn) .&&. within 4e-15 (cn * cn + m1 * sn * sn) (dn * dn)

    prop "has the derivatives cn dn, −sn dn, −m sn cn" $ \(Complement m1) (Fraction f) ->
      let md = modulus m1
          x = f * quarterPeriod md
          Jacobi sn cn dn = jacobi md x
          slopeOf g = differential (g . jacobi md) x
       in within 1e-9 (cn * dn) (slopeOf jacobiSn)
            .&&. within 1e-9 (-sn * dn) (slopeOf jacobiCn)
            .&&. within 1e-9 (-(1 - m1) * sn * cn) (slopeOf jacobiDn)

    prop "agrees with the descending Landen transformation" $ \(Complement m1) (Fraction f) ->
      m1 > 1e-4
        ==> let md = modulus m1
                x = f * quarterPeriod md
                phi = landenAmplitude m1 x
                Jacobi sn cn dn = jacobi md x
             in within 2e-14 (sin phi) sn
                  .&&. within 2e-14 (cos phi) cn
                  .&&. within 2e-14 (sqrt (cos phi ^ (2 :: Int) + m1 * sin phi ^ (2 :: Int))) dn

    prop "is circular for m = 0" $ \(Fraction f) ->
      let x = 3 * f
          Jacobi sn cn dn = jacobi (modulus 1) x
       in within 2e-15 (sin x) sn .&&. within 2e-15 (cos x) cn .&&. within 1e-15 1 dn

    prop "is hyperbolic for m = 1" $
      forAll (choose (-40, 40)) $ \x ->
        let Jacobi sn cn dn = jacobi (modulus 0) x
         in within 1e-15 (tanh x) sn .&&. closeTo 1e-13 (1 / cosh x) cn
              .&&. closeTo 1e-13 (1 / cosh x) dn

    prop "passes to the hyperbolic limit as m → 1" $
      forAll (choose (-5, 5)) $ \x ->
        let Jacobi sn cn dn = jacobi (modulus 1e-20) x
         in within 1e-14 (tanh x) sn .&&. closeTo 1e-13 (1 / cosh x) cn
              .&&. closeTo 1e-13 (1 / cosh x) dn

    prop "keeps the relative accuracy of sn near 0" $ \(Complement m1) ->
      forAll ((10 **) <$> choose (-200, -9)) $ \x ->
        closeTo 2e-15 x (jacobiSn (jacobi (modulus m1) x))

    prop "repeats after four quarter periods" $ \(Complement m1) (Fraction f) ->
      let md = modulus m1
          k = quarterPeriod md
          Jacobi sn cn dn = jacobi md (f * k)
          Jacobi sn' cn' dn' = jacobi md (f * k + 4 * k)
       in -- The rounding of the argument, and no more.
          within (1e-15 * (1 + 6 * k)) sn sn'
            .&&. within (1e-15 * (1 + 6 * k)) cn cn'
            .&&. within (1e-15 * (1 + 6 * k)) dn dn'

    it "keeps its digits where cn is as small as the complementary modulus" $ do
      -- m₁ = 1.1311046058110684e-27 at x = 46.12265190702485: 120-digit arithmetic.
      let Jacobi _ cn _ = jacobi (modulus 1.1311046058110684e-27) 46.12265190702485
      cn `shouldSatisfy` (\v -> abs (v / (-1.51784001427561e-8) - 1) < 1e-12)

    it "is finite for every finite argument" $
      [ (m1, x)
        | m1 <- [0, 1e-300, 1e-30, 0.3, 0.5, 0.7, 1],
          x <- [0, 1e-300, 1, -700, 750, 1e6],
          let Jacobi sn cn dn = jacobi (modulus m1) x,
          not (all ((<= 1 + 1e-12) . abs) [sn, cn, dn])
      ]
        `shouldBe` []

  describe "snSquared and tanHalfAmplitude" $ do
    prop "agree with jacobi" $ \(Complement m1) (Fraction f) ->
      let md = modulus m1
          x = f * quarterPeriod md
          Jacobi sn cn _ = jacobi md x
          t = tanHalfAmplitude md x
       in within 4e-14 (sn * sn) (snSquared md x)
            -- Half-angle formulas, each where it has its digits.
            .&&. ( if cn >= 0
                     then within 1e-13 (sn / (1 + cn)) t
                     else within 1e-13 (sn / (1 - cn)) (1 / t)
                 )

    prop "are exact for m = 0" $
      forAll (choose (-3.1, 3.1)) $ \x ->
        within 1e-15 (sin x * sin x) (snSquared (modulus 1) x)
          .&&. closeTo 1e-14 (tan (0.5 * x)) (tanHalfAmplitude (modulus 1) x)

  describe "completeK" $ do
    it "has the known values" $ do
      completeK 1 `shouldSatisfy` isNear 1e-15 (pi / 2)
      -- Γ(1/4)² / (4 √π)
      completeK 0.5 `shouldSatisfy` isNear 1e-15 1.8540746773013719184
      -- DLMF 19.8, m = 0.81
      completeK (1 - 0.81) `shouldSatisfy` isNear 1e-15 2.2805491384227701
      completeK 1e-30 `shouldSatisfy` isNear 1e-15 (log 4 + 15 * log 10)
      completeK 0 `shouldBe` 1 / 0

    prop "agrees with the integral" $
      forAll (choose (0.02, 1)) $ \m1 ->
        closeTo 1e-13 (trapezoidalK m1) (completeK m1)

    prop "obeys Landen's transformation" $ \(Complement m1) ->
      m1 > 1e-12
        ==> let k' = sqrt m1
                lower = 2 * sqrt k' / (1 + k')
             in closeTo 1e-14 (completeK m1) (2 / (1 + k') * completeK (lower * lower))

  describe "incompleteF" $ do
    prop "inverts the amplitude" $ \(Complement m1) ->
      forAll (choose (-1, 1)) $ \f ->
        let md = modulus m1
            x = f * quarterPeriod md
            Jacobi sn cn _ = jacobi md x
         in within (1e-14 * (1 + abs x)) x (signum x * firstQuadrantF m1 (sn * sn) (cn * cn))

    prop "agrees with the integral" $ \(Complement m1) ->
      forAll (choose (-1.4, 1.4)) $ \phi ->
        within 1e-12 (gaussianF m1 phi) (incompleteF m1 phi)

    prop "gains 2K per half turn" $
      forAll (choose (0.01, 1)) $ \m1 ->
        forAll (choose (-7, 7)) $ \phi ->
          within 1e-12 (incompleteF m1 phi + 2 * completeK m1) (incompleteF m1 (phi + pi))

    it "is the Gudermannian's inverse for m = 1" $
      incompleteF 0 1.2 `shouldSatisfy` isNear 1e-14 (atanh (sin 1.2))

  describe "carlsonRF" $ do
    it "has the published values" $ do
      -- Carlson 1995, "Numerical computation of real or complex elliptic integrals"
      carlsonRF 1 2 0 `shouldSatisfy` isNear 5e-14 1.3110287771461
      carlsonRF 0.5 1 0 `shouldSatisfy` isNear 5e-14 1.8540746773014
      carlsonRF 2 3 4 `shouldSatisfy` isNear 5e-14 0.58408284167715
      carlsonRF 1 1 1 `shouldSatisfy` isNear 1e-15 1
      carlsonRF 0 0 1 `shouldBe` 1 / 0

    prop "is symmetric and of degree −1/2" $
      forAll ((10 **) <$> choose (-20, 3)) $ \x ->
        forAll ((10 **) <$> choose (-3, 3)) $ \y ->
          let r = carlsonRF x y 1
           in closeTo 1e-14 r (carlsonRF 1 x y)
                .&&. closeTo 1e-14 (r / 3) (carlsonRF (9 * x) (9 * y) 9)
  where
    isNear limit expected actual = abs (actual / expected - 1) <= limit

-- | A derivative by central differences, extrapolated to order 4.
differential :: (Double -> Double) -> Double -> Double
differential g x = (4 * central 5e-4 - central 1e-3) / 3
  where
    central h = (g (x + h) - g (x - h)) / (2 * h)

-- | The amplitude by the arithmetic-geometric mean (Abramowitz and Stegun
-- 16.4).
landenAmplitude :: Double -> Double -> Double
landenAmplitude m1 x = foldl down (2 ^ length ratios * mean * x) (reverse ratios)
  where
    (mean, ratios) = means 1 (sqrt m1) (sqrt (1 - m1))
    down phi ratio = 0.5 * (phi + asin (ratio * sin phi))
    means a b c
      | c < 1e-15 = (a, [])
      | otherwise =
        let a' = 0.5 * (a + b)
            c' = 0.5 * (a - b)
            (final, rest) = means a' (sqrt (a * b)) c'
         in (final, c' / a' : rest)

-- | @K@ by the trapezoidal rule, which converges geometrically for this
-- periodic integrand.
trapezoidalK :: Double -> Double
trapezoidalK m1 = pi / (2 * n) * sum [value ((i + 0.5) * pi / (2 * n)) | i <- [0 .. n - 1]]
  where
    n = 128 :: Double
    value t = 1 / sqrt (cos t * cos t + m1 * sin t * sin t)

-- | @F@ by Gauss's five-point rule on 40 pieces.
gaussianF :: Double -> Double -> Double
gaussianF m1 phi = sum [piece (i * h) | i <- [0 .. n - 1]]
  where
    n = 40
    h = phi / n
    piece left = 0.5 * h * sum [w * value (left + 0.5 * h * (1 + t)) | (t, w) <- rule]
    value t = 1 / sqrt (cos t * cos t + m1 * sin t * sin t)
    inner = sqrt (5 - 2 * sqrt (10 / 7)) / 3
    outer = sqrt (5 + 2 * sqrt (10 / 7)) / 3
    innerWeight = (322 + 13 * sqrt 70) / 900
    outerWeight = (322 - 13 * sqrt 70) / 900
    rule =
      [ (0, 128 / 225),
        (inner, innerWeight),
        (-inner, innerWeight),
        (outer, outerWeight),
        (-outer, outerWeight)
      ]
