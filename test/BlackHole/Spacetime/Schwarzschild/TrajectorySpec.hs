module BlackHole.Spacetime.Schwarzschild.TrajectorySpec (spec) where

import BlackHole.Matter.PathReport
import BlackHole.Numeric.Angle
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Spacetime.Schwarzschild.TrajectoryPoints
import BlackHole.Vector.XYZ (XYZ (..), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import qualified Support.Reference as Reference
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  describe "the reference rays of a camera at rest" $ do
    rays <- runIO Reference.readRays
    it "are fifteen" $ length rays `shouldBe` 15
    mapM_ referenceRay rays
  describe "light from infinity" $ do
    table <- runIO Reference.readDeflections
    it "is turned as in the table" $
      sequence_
        [ fromMaybe nan (trajectoryDeflection (trajectoryFromInfinity overPole b))
            `shouldBeWithin` (1e-10, value)
          | Reference.Deflection b _ value <- table
        ]
    prop "comes in on its asymptote" $
      forAll (oneof [choose (0.01, 2.59), choose (2.61, 50)]) $ \b ->
        conjoin
          [ closeTo (1e-5 * b) b x
            | TrajectoryPoint _ (Photon (XYZ x _ _) _) <-
                take 1 (trajectoryPoints 1e7 0.05 (trajectoryFromInfinity overPole b))
          ]
    prop "keeps unit energy and its impact parameter at every point" $
      forAll (oneof [choose (0.01, 2.59), choose (2.61, 50)]) $ \b ->
        conjoin
          [ closeTo 1e-12 1 (2 * pseudoEnergy p)
              .&&. closeTo (1e-11 * b) b (XYZ.norm (angularMomentum p))
            | TrajectoryPoint _ p <- trajectoryPoints 100 0.05 (trajectoryFromInfinity overPole b)
          ]
    prop "moves along its velocity" $
      forAll (oneof [choose (0.01, 2.59), choose (2.61, 50)]) $ \b ->
        let photons =
              map
                pointPhoton
                (init' (trajectoryPoints 100 0.01 (trajectoryFromInfinity overPole b)))
            cosine (Photon x v) (Photon x' v') =
              let chord = x' ^-^ x
                  mean = v ^+^ v'
               in XYZ.dot chord mean / (XYZ.norm chord * XYZ.norm mean)
         in conjoin (zipWith (\p q -> closeTo 1e-4 1 (cosine p q)) photons (drop 1 photons))
    prop "crosses the plane as the same photon followed from nearby does" $
      forAll
        ( (,,)
            <$> oneof [choose (1, 2.5), choose (2.65, 12)] <*> choose (0.2, 1.4) <*> choose (-3, 3)
        )
        $ \(b, i, eta) ->
          let trajectory = trajectoryFromInfinity (Sight (Radians i) (Radians eta)) b
              nearby =
                [ trajectoryFromPhoton 1 p
                  | TrajectoryPoint _ p <- take 1 (trajectoryPoints 60 0.05 trajectory)
                ]
              same (PlaneCrossing r azimuth g) (PlaneCrossing r' azimuth' g') =
                closeTo (1e-8 * r) r r' .&&. closeTo 1e-9 0 (sin (azimuth - azimuth'))
                  .&&. closeTo 1e-8 g g'
              near = filter ((< 59) . crossingRadius) . crossings
           in conjoin
                [ length (near trajectory)
                    === length (near c) .&&. conjoin (zipWith same (near trajectory) (near c))
                  | c <- nearby
                ]
    it "ends at the horizon below b_c" $
      sequence_
        [ case trajectoryPoints 100 0.05 (trajectoryFromInfinity overPole b) of
            [] -> expectationFailure "no points"
            points ->
              XYZ.norm (photonPosition (pointPhoton (last points))) `shouldBeWithin` (1e-9, 1)
          | b <- [0, 1e-9, 0.3, 2, 2.5, 2.598, criticalImpactParameter - 1e-14]
        ]
    it "is continuous in b across the series and the closed form" $
      sequence_
        [ fromMaybe nan (trajectoryDeflection (trajectoryFromInfinity overPole b))
            `shouldBeWithin` (1e-14, fromMaybe nan (deflectionAngle b))
          | b <- [3, 19.9, 20.1, 1000]
        ]
    it "has ends also next to b_c" $
      sequence_
        [ trajectorySweep (trajectoryFromInfinity overPole (criticalImpactParameter + d))
            `shouldSatisfy` (\a -> a > 20 && a < 60)
          | d <- [-4e-16, 0, 4e-16, 4e-15, -4e-15]
        ]
  describe "crossings of the disk's plane" $ do
    it "of light along the axis lie at quarter turns" $
      map crossingAzimuth (crossings (trajectoryFromInfinity overPole 2.65)) `shouldBe` [0, -pi]
    it "are none for light in the plane" $
      crossings (trajectoryFromInfinity (Sight (Radians (pi / 2)) (Radians 0)) 2.65) `shouldBe` []
    it "of a photon on the photon sphere are those of four turns" $
      case trajectoryFromCamera overPole 1.5 (Radians (pi / 2)) of
        Just trajectory ->
          (trajectoryFate trajectory, map crossingRadius (crossings trajectory))
            `shouldBe` (Circles, replicate 8 1.5)
        Nothing -> expectationFailure "no such camera"
    it "do not count the start" $
      map
        crossingAzimuth
        ( maybe
            []
            crossings
            (trajectoryFromCamera (Sight (Radians (pi / 2)) (Radians (pi / 2))) 10 (Radians 0.35))
        )
        `shouldSatisfy` all ((< 1e-9) . abs . (+ pi / 2))
    it "show the extremes of g to a far observer in the plane" $
      -- Light that leaves an orbit along its motion turns there, and so has
      -- b = r/√(1−1/r). Positive λ comes from the left.
      sequence_
        [ case redshiftAtTurn r side of
            Nothing -> expectationFailure "no crossing at the closest point"
            Just redshift -> redshift `shouldBeWithin` (2e-7, g)
          | (r, g, side) <-
              [(4, 1.3359816, -1), (4, 0.56138496, 1), (6, 1.2665408, -1), (6, 0.65796014, 1)]
        ]
  where
    nan = 0 / 0
    -- The last point is as near as it happens to be.
    init' points = zipWith const points (drop 1 points)
    -- The observer stands off the plane by next to nothing, and looks past the
    -- hole on the right (1) or left (−1) so that the path crosses the plane at
    -- its closest point, after half of what it sweeps: there
    -- cos i cos φ + sin η sin i sin φ = 0.
    redshiftAtTurn :: Double -> Double -> Maybe Double
    redshiftAtTurn r side =
      case [ crossingLight c
             | c <- crossings (trajectoryFromInfinity sight b),
               abs (crossingRadius c - r) < 1e-6
           ] of
        [redshift] -> Just redshift
        _ -> Nothing
      where
        b = r / sqrt (1 - 1 / r)
        half = 0.5 * trajectorySweep (trajectoryFromInfinity overPole b)
        tilt = 1e-6
        rise = asin (negate (sin tilt / (cos tilt * tan half)))
        sight = Sight (Radians (pi / 2 - tilt)) (Radians (if side > 0 then rise else pi - rise))

-- | The crossings of the disk's plane, with g.
crossings :: Trajectory -> [PlaneCrossing Double]
crossings = reportCrossings . exactReport 100

overPole :: Sight
overPole = Sight (Radians 0) (Radians 0)

referenceRay :: Reference.Ray -> Spec
referenceRay ray = it
  ( show
      ( Reference.rayCameraRadius ray,
        Reference.rayInclination ray,
        Reference.rayPsi ray,
        Reference.rayEta ray,
        Reference.crossingNumber <$> Reference.rayCrossing ray
      )
  )
  $ case trajectoryFromCamera
    sight
    (Reference.rayCameraRadius ray)
    (degrees (Reference.rayPsi ray)) of
    Nothing -> expectationFailure "no such camera"
    Just trajectory -> do
      trajectoryImpactParameter trajectory
        `shouldBeWithin` (1e-12, Reference.rayImpactParameter ray)
      case (trajectoryFate trajectory, Reference.rayFate ray) of
        (Escaped _, Reference.RayEscapes reference) ->
          trajectorySweep trajectory `shouldBeWithin` (1e-10, reference)
        (Captured, Reference.RayCaptured) -> pure ()
        (fate, reference) -> expectationFailure (show (fate, reference))
      case Reference.rayCrossing ray of
        Nothing -> crossings trajectory `shouldBe` []
        Just (Reference.Crossing n r azimuth g) -> case drop (n - 1) (crossings trajectory) of
          [] -> expectationFailure "crossing missing"
          PlaneCrossing r' azimuth' g' : _ -> do
            r' `shouldBeWithin` (1e-9 * r, r)
            azimuth' `shouldBeWithin` (1e-9, azimuth)
            g' `shouldBeWithin` (1e-9, g)
  where
    degrees = toRadians . Degrees
    sight = Sight (degrees (Reference.rayInclination ray)) (degrees (Reference.rayEta ray))
