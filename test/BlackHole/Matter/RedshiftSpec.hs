{-# LANGUAGE BangPatterns #-}

module BlackHole.Matter.RedshiftSpec (spec) where

import BlackHole.Matter.GasFlow
import BlackHole.Matter.GasMotion
import BlackHole.Matter.Redshift
import BlackHole.Spacetime.Momentum
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..), cross, dot, norm, (*^), (^+^))
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "g" $ do
    it "has the published extremes for a distant observer in the plane" $
      mapM_
        ( \(r, blue, red) -> do
            let shifts = equatorialShifts r
            maximum shifts `shouldSatisfy` near 5e-8 blue
            minimum shifts `shouldSatisfy` near 5e-8 red
        )
        [(4, 1.3359816, 0.56138496), (6, 1.2665408, 0.65796014)]
    prop "is the closed form √(1−3/(2r))/(1−Ωλ) on circular orbits" $
      forAll ((,) <$> choose (3, 100) <*> choose (-1, 1)) $ \(r, s) ->
        let lambda = s * r / sqrt (1 - 1 / r)
         in [ 1 / frequencyInGas (gasFrequencies flow r 0 (planeMomentum sense lambda r))
              | sense <- [-1, 1]
            ]
              `shouldSatisfy` \shifts ->
                length shifts == 2
                  && all
                    (near 1e-14 (sqrt (1 - 1.5 / r) / (1 - lambda / sqrt (2 * r ** 3))))
                    shifts
    prop "is 1 between observers at rest at one place" $
      forAll somewhere $ \(position, direction) ->
        let r = norm position
         in ( redshiftGravitational
                <$> (staticFrequency r >>= \observed -> gasRedshift observed position direction)
            )
              `shouldSatisfy` maybe False (near 1e-14 1)
    prop "is continuous across the innermost stable orbit" $
      forAll somewhere $ \(place, direction) ->
        let at r = gasRedshift 1 ((r / norm place) *^ place) direction
         in (,) <$> fmap redshiftFactor (at 3) <*> fmap redshiftFactor (at (3 - 1e-8))
              `shouldSatisfy` maybe False (\(g, g') -> abs (g - g') < 1e-7 * g)

  describe "its factors" $ do
    prop "have the product g" $
      forAll somewhere $ \(position, direction) ->
        gasRedshift 1.25 position direction
          `shouldSatisfy` maybe
            False
            (\(Redshift g gravity doppler) -> near 1e-14 g (gravity * doppler))
    prop "is the Doppler formula of special relativity beside the gas" $
      forAll somewhere $ \(position, direction) ->
        fmap redshiftDoppler (gasRedshift 1 position direction)
          `shouldSatisfy` maybe False (near 1e-11 (localDoppler position direction))
    it "has gravity's part alone for gas at rest" $
      fmap redshiftGravitational (gasRedshift 1 (XYZ 4 0 0) (XYZ 1 0 0))
        `shouldSatisfy` maybe False (near 1e-15 (sqrt 0.75))

  describe "gasRedshift" $ do
    it "brightens the side that comes towards the observer" $ do
      -- Seen from +z, right-handed rotation about +y brings the gas at −x near.
      let doppler position =
            redshiftDoppler <$> gasRedshift 1 position (XYZ 0 0 1)
      doppler (XYZ (-8) 0 0) `shouldSatisfy` maybe False (> 1.2)
      doppler (XYZ 8 0 0) `shouldSatisfy` maybe False (< 0.85)
    it "reddens gas that moves across the line of sight by 1/γ" $
      fmap redshiftDoppler (gasRedshift 1 (XYZ 0 0 8) (XYZ 0 1 0))
        -- v² = Ω²r²/(1−1/r) = 1/14.
        `shouldSatisfy` maybe False (near 1e-14 (sqrt (13 / 14)))
    it "reddens gas that falls away, more so near the horizon" $ do
      let shifts =
            [ redshiftFactor g
              | r <- [2.9, 2.5, 2, 1.5, 1.2, 1.05, 1.001],
                Just g <- [gasRedshift 1 (XYZ r 0 0) (XYZ 1 0 0)]
            ]
      length shifts `shouldBe` 7
      filter (uncurry (<=)) (zip shifts (drop 1 shifts)) `shouldBe` []
    prop "is a positive number everywhere outside the horizon" $
      forAll somewhere $ \(position, direction) ->
        fmap redshiftFactor (gasRedshift 1 position direction)
          `shouldSatisfy` maybe False (\g -> g > 0 && g < 1e3)
    it "has nothing to say inside the horizon or about no direction" $
      [ gasRedshift 1 (XYZ 0.9 0 0) (XYZ 1 0 0),
        gasRedshift 1 (XYZ 1 0 0) (XYZ 1 0 0),
        gasRedshift 1 (XYZ 3 0 0) (XYZ 0 0 0),
        gasRedshift 1 (XYZ (0 / 0) 0 0) (XYZ 1 0 0)
      ]
        `shouldBe` replicate 4 Nothing

  describe "momentumOf" $ do
    prop "agrees with the constants of the orbit" $
      forAll somewhere $ \(position, velocity) ->
        let r = norm position
            h = cross position velocity
            XYZ _ hy _ = h
            scale2 = dot velocity velocity - dot h h / (r * r * r)
            kr = sqrt (max 0 (1 - (1 - 1 / r) * dot h h / scale2 / (r * r))) / (1 - 1 / r)
            expected = Momentum (signum (dot position velocity) * kr) (hy / sqrt scale2)
         in momentumOf (Photon position velocity)
              `shouldSatisfy` maybe False (momentumNear 1e-6 expected)
    prop "does not depend on the length of the velocity" $
      forAll somewhere $ \(position, velocity) ->
        (,)
          <$> momentumOf (Photon position velocity)
          <*> momentumOf (Photon position (37 *^ velocity))
            `shouldSatisfy` maybe False (uncurry (momentumNear 1e-12))
    prop "is null: what is left for the latitude is not negative" $
      forAll somewhere $ \(position@(XYZ x _ z), velocity) ->
        fmap
          ( \(Momentum kr lambda) ->
              let r = norm position
                  lapse2 = 1 - 1 / r
               in 1 / lapse2 - lapse2 * kr * kr - lambda * lambda / (x * x + z * z)
          )
          (momentumOf (Photon position velocity))
          `shouldSatisfy` maybe False (> -1e-9)

  describe "the reference rays" $
    it "cross the disk where and with the shift that 30-digit arithmetic says" $
      mapM_
        ( \ray -> do
            let (r, g) = traced ray
            (ray, r) `shouldSatisfy` (near 1e-9 (rayCrossing ray) . snd)
            (ray, g) `shouldSatisfy` (maybe False (near 1e-9 (rayShift ray)) . snd)
        )
        referenceRays
  where
    near limit expected value =
      abs (value - expected) <= limit * abs (expected :: Double)
    momentumNear limit (Momentum a b) (Momentum a' b') =
      abs (a - a') <= limit * (1 + abs a) && abs (b - b') <= limit * (1 + abs b)

-- | g of light that leaves the gas at r in all directions within the plane.
-- The direction enters through λ = r sin α/√(1−1/r), α being the angle from
-- the radius for an observer at rest there, so that the extremes belong to light
-- that leaves along the ring, |λ| = b = r/√(1−1/r); for r > 3/2 the ring is then
-- the closest approach, and the light escapes.
equatorialShifts :: Double -> [Double]
equatorialShifts r =
  [ 1 / frequencyInGas (gasFrequencies flow r 0 (planeMomentum 1 lambda r))
    | i <- [-180 .. 180 :: Int],
      let alpha = pi / 360 * fromIntegral i,
      let lambda = r * sin alpha / sqrt (1 - 1 / r)
  ]

flow :: GasFlow
flow = gasFlow Schwarzschild

-- | The momentum at a radius of light within the plane that moves outwards (1) or inwards
-- (−1), of which λ is then the impact parameter.
planeMomentum :: Double -> Double -> Double -> Momentum
planeMomentum sense lambda r =
  Momentum (sense * sqrt (max 0 (1 - (1 - 1 / r) * lambda * lambda / (r * r))) / (1 - 1 / r)) lambda

-- | The shift of light that leaves the gas at a position in this direction, for an
-- observer's frequency.
gasRedshift :: Double -> XYZ -> XYZ -> Maybe Redshift
gasRedshift observed position@(XYZ _ y _) direction =
  redshift observed . gasFrequencies flow (norm position) y
    <$> momentumOf (Photon position direction)

-- | A place outside the horizon, off the axis, and a direction.
somewhere :: Gen (XYZ, XYZ)
somewhere = do
  r <- (\e -> 1 + 10 ** e) <$> choose (-2, 3)
  place <- unit `suchThat` \(XYZ x _ z) -> x * x + z * z > 1e-4
  direction <- unit
  pure (r *^ place, direction)
  where
    unit = do
      h <- choose (-1, 1)
      angle <- choose (0, 2 * pi)
      let s = sqrt (1 - h * h)
      pure (XYZ (s * cos angle) h (s * sin angle))

-- | √(1−β²)/(1 − n·β) from the gas's velocity and the light's direction as who
-- is at rest beside the gas measures them: radial lengths are stretched by
-- 1/√(1−1/r) against pseudo-space, times by √(1−1/r).
localDoppler :: XYZ -> XYZ -> Double
localDoppler position@(XYZ x y z) velocity =
  case gasVelocity r y of
    Nothing -> 0 / 0
    Just (FourVelocity ut ur uphi) ->
      let betaRadial = ur / (ut * lapse2)
          betaAround = rho * uphi / (ut * sqrt lapse2)
       in sqrt (1 - betaRadial * betaRadial - betaAround * betaAround)
            / (1 - betaRadial * nRadial - betaAround * nAround)
  where
    r = norm position
    rho = sqrt (x * x + z * z)
    lapse2 = 1 - 1 / r
    radial = (1 / r) *^ position
    forwards = (1 / rho) *^ XYZ z 0 (-x)
    vRadial = dot velocity radial
    -- In the local frame the tangential part counts √(1−1/r) times as much.
    tangential = velocity ^+^ negate vRadial *^ radial
    local = vRadial *^ radial ^+^ sqrt lapse2 *^ tangential
    nRadial = vRadial / norm local
    nAround = dot local forwards / norm local

-- | A row of the reference table: a static camera at a distance and an
-- inclination, the pixel's direction by ψ from inwards and η from screen-right
-- to screen-up (degrees), and the n-th crossing of the disk plane with its
-- radius and g.
data Ray = Ray
  { rayDistance :: Double,
    rayInclination :: Double,
    rayPsi :: Double,
    rayEta :: Double,
    rayNumber :: Int,
    rayCrossing :: Double,
    rayShift :: Double
  }
  deriving (Show)

referenceRays :: [Ray]
referenceRays =
  [ Ray 20 80 10 90 1 3.8663651396947 0.80265264943582,
    Ray 20 80 10 0 1 2.9721268637903 0.48647213075273,
    Ray 20 80 10 180 1 2.9721268637903 1.3998294461363,
    Ray 20 80 10 (-90) 1 10.27369270291 0.94812614213424,
    Ray 20 80 10 (-90) 2 5.270456428829 0.86778281804296,
    Ray 20 80 7.3 90 1 1.6308850192954 0.40913467072976,
    Ray 20 80 7.3 90 2 1.8299961424778 0.5200312764386,
    Ray 30 60 8 45 1 4.1031130875393 0.66336031515719,
    Ray 20 80 7 90 1 1.4465756636076 0.30279425560646,
    Ray 6 85 30 60 1 4.3217856104718 0.78413810835351,
    Ray 20 80 15 (-30) 1 9.2525317983317 0.84318453954369,
    Ray 50 88 3.5 120 1 2.6392612983134 0.89851160324736,
    Ray 10 45 16 200 1 2.4758331290601 0.99519818779183,
    Ray 10 45 16 200 2 7.3916300440564 1.0096663655161
  ]

-- | Where a reference ray crosses the disk plane, and g of the gas there: the
-- path is u'' = (3/2)u² − u, by Runge and Kutta's rule over the angle to the
-- crossing, which geometry gives.
traced :: Ray -> (Double, Maybe Double)
traced (Ray distance inclination psi eta number _ _) =
  ( 1 / u,
    ( \observed ->
        observed / frequencyInGas (gasFrequencies flow (1 / u) 0 (Momentum (sense * radial) lambda))
    )
      <$> staticFrequency distance
  )
  where
    radians degrees = degrees * pi / 180
    i = radians inclination
    -- The photon flies the other way round than the line of sight.
    sense = if slope > 0 then 1 else -1
    radial = sqrt (max 0 (1 - (1 - u) * b * b * u * u)) / (1 - u)
    lambda = negate (b * sin i * cos (radians eta))
    b = distance * sin (radians psi) / sqrt (1 - 1 / distance)
    -- y = 0 on the circle cos φ e_r + sin φ t, e_r = (0, cos i, sin i) and
    -- t = (cos η, sin η sin i, −sin η cos i).
    angle =
      atan2 (cos i) (negate (sin (radians eta) * sin i))
        + pi * fromIntegral (number - 1)
    u0 = 1 / distance
    slope0 = u0 * sqrt (1 - u0) / tan (radians psi)
    steps = 4000 :: Int
    h = angle / fromIntegral steps
    (u, slope) = go steps u0 slope0
    force q = 1.5 * q * q - q
    go :: Int -> Double -> Double -> (Double, Double)
    go n !q !p
      | n <= 0 = (q, p)
      | otherwise =
        let p1 = force q
            q2 = p + h / 2 * p1
            p2 = force (q + h / 2 * p)
            q3 = p + h / 2 * p2
            p3 = force (q + h / 2 * q2)
            q4 = p + h * p3
            p4 = force (q + h * q3)
         in go
              (n - 1)
              (q + h / 6 * (p + 2 * q2 + 2 * q3 + q4))
              (p + h / 6 * (p1 + 2 * p2 + 2 * p3 + p4))
