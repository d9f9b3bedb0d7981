module BlackHole.Spacetime.FollowSpec (spec) where

import BlackHole.Matter.GasFlow (gasFlow)
import BlackHole.Matter.Redshift
import BlackHole.Spacetime.Follow
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_)
import Support.Approx
import Support.Generators
import Support.Reference (Ray (..), crossingNumber, crossingRedshiftFactor, readRays)
import qualified Support.Reference as Reference
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec = do
  it "are where the reference rays have them, with their g" $ do
    rays <- readRays
    length rays `shouldBe` 15
    forM_ rays $ \ray ->
      compared 1e-9 1e-9 InClosedForm ray
  it "so are the table's, to its own accuracy" $ do
    rays <- readRays
    forM_ [ray | ray <- rays, rayImpactParameter ray > 2.7] $
      compared 1e-5 1e-5 ByTable
  it "so are the leapfrog's, to its own accuracy" $ do
    rays <- readRays
    forM_ [ray | ray <- rays, rayImpactParameter ray > 2.7] $
      compared 2e-3 2e-3 (ByLeapfrog defaultLeapfrog {leapfrogSteps = ReportSteps 0.02 0.01})
  it "are as many as the reference has" $ do
    rays <- readRays
    forM_ rays $ \ray ->
      length (crossings InClosedForm ray)
        `shouldBe` length
          [() | other <- rays, place other == place ray, Just _ <- [rayCrossing other]]
  prop
    "a straight ray's is where a line meets a plane"
    $ \(Outside x@(XYZ _ y _)) (Direction d@(XYZ _ climb _)) ->
      XYZ.norm (XYZ.cross x d) > 1
        ==> case (sightLine Flat Static x d, y * climb < 0) of
          (Just sight, True) -> case planeCrossings straight sight of
            [crossing] ->
              let r = XYZ.norm (x ^+^ (-y / climb) *^ d)
               in closeTo (1e-9 * max 1 r) r (crossingRadius crossing)
            other -> counterexample (show other) False
          (Just sight, False) -> planeCrossings straight sight === []
          (Nothing, _) -> counterexample "no line of sight" False
  prop "the plane's own light does not cross it" $
    forAll ((,) <$> inRange 1.1 40 <*> inRange 0 6.2) $ \(r, angle) ->
      fmap
        (planeCrossings (tracing Schwarzschild InClosedForm (XYZ r 0 0)))
        (sightLine Schwarzschild Static (XYZ r 0 0) (XYZ (cos angle) 0 (sin angle)))
        === Just []
  where
    place ray = map ($ ray) [rayCameraRadius, rayInclination, rayPsi, rayEta]
    straight = tracing Flat InClosedForm (XYZ 1 0 0)
    compared limit shiftLimit method ray = forM_ (rayCrossing ray) $ \expected ->
      case drop (crossingNumber expected - 1) (crossings method ray) of
        PlaneCrossing r azimuth (Just shift) : _ -> do
          r `shouldBeWithin` (limit * r, Reference.crossingRadius expected)
          XYZ (cos azimuth) 0 (sin azimuth)
            `nearPoint` (limit, let a = Reference.crossingAzimuth expected in XYZ (cos a) 0 (sin a))
          redshiftFactor shift `shouldBeWithin` (shiftLimit, crossingRedshiftFactor expected)
        other -> expectationFailure (show other)
    nearPoint a (limit, b) = XYZ.distance a b `shouldBeWithin` (limit, 0)

-- | The crossings of a reference ray.
crossings :: Method -> Ray -> [PlaneCrossing (Maybe Redshift)]
crossings method ray =
  case sightLine Schwarzschild Static (rayCameraRadius ray *^ outward) direction of
    Just sight ->
      [ crossingRedshift (gasFlow Schwarzschild) sight c <$ c
        | c <- planeCrossings (tracing Schwarzschild method (XYZ (rayCameraRadius ray) 0 0)) sight
      ]
    Nothing -> []
  where
    radians degrees = degrees * pi / 180
    i = radians (rayInclination ray)
    psi = radians (rayPsi ray)
    eta = radians (rayEta ray)
    outward = XYZ 0 (cos i) (sin i)
    up = XYZ 0 (sin i) (negate (cos i))
    direction =
      (negate (cos psi) *^ outward)
        ^+^ sin psi *^ (cos eta *^ XYZ 1 0 0 ^+^ sin eta *^ up)
