module BlackHole.Matter.KerrReportSpec (spec) where

import BlackHole.Matter.KerrReport
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Follow (Method (InClosedForm))
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.PlaneCrossing (PlaneCrossing (PlaneCrossing))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.KerrReference
import Test.Hspec

spec :: Spec
spec = do
  it "lists the crossings of the reference rays" $ do
    rows <- readKerrRays
    sequence_
      [ sequence_
          [ do
              r `shouldBeWithin` (1e-11 * crossingRadius known, crossingRadius known)
              azimuth `shouldBeWithin` (1e-11, crossingAzimuth known)
              g `shouldBeWithin` (1e-11 * crossingRedshift known, crossingRedshift known)
            | (PlaneCrossing r azimuth g, known) <-
                zip (kerrReportCrossings (reportOf row)) (rayCrossings row)
          ]
        | row <- rows
      ]
  it "draws a path from the observer to the edge of the drawing" $ do
    let points =
          [ place
            | KerrPathPoint _ place <- kerrReportPath (reportAlong 0.9 30 1.43 (aimed 0.2 0.5))
          ]
    map XYZ.norm (take 1 points ++ take 1 (reverse points))
      `shouldSatisfy` (\ends -> and (zipWith (\r known -> abs (r - known) < 1e-6) ends [30, 100]))
    zipWith (\p q -> XYZ.distance p q / XYZ.norm p) points (drop 1 points)
      `shouldSatisfy` all (< 0.03)
  it "draws a captured path down to the horizon" $ do
    let report = reportAlong 0.9 30 1.43 (aimed 0.02 0.5)
    kerrReportFate report `shouldBe` Captured
    [XYZ.norm place | KerrPathPoint _ place <- take 1 (reverse (kerrReportPath report))]
      `shouldSatisfy` all (\r -> abs (r - horizonRadius (spinOf 0.9)) < 1e-6)
  where
    reportOf row =
      kerrReport
        InClosedForm
        (raySpin row)
        100
        (BoyerLindquist 0)
        ( fromMaybe
            (error (rayName row))
            (lightRay (raySpin row) (rayPlace row) (rayMotion row) (rayDirection row))
        )
    reportAlong s r theta direction =
      kerrReport
        InClosedForm
        (spinOf s)
        100
        (BoyerLindquist 0)
        (fromMaybe (error "dark") (lightRay (spinOf s) (Place r theta) AtRest direction))
