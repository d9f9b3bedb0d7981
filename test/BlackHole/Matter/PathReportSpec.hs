module BlackHole.Matter.PathReportSpec (spec) where

import BlackHole.Matter.PathReport
import BlackHole.Numeric.Angle
import BlackHole.Spacetime.Fate (fateName)
import BlackHole.Spacetime.PlaneCrossing
import BlackHole.Spacetime.Schwarzschild.StepRule
import BlackHole.Spacetime.Schwarzschild.Trajectory
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Approx
import Test.Hspec

spec :: Spec
spec = do
  describe "the exact report" $ do
    it "drifts by rounding only" $
      sequence_
        [ do
            fromMaybe nan (reportAngularMomentumDrift report) `shouldBeWithin` (1e-13, 0)
            fromMaybe nan (reportEnergyDrift report) `shouldBeWithin` (1e-13, 0)
          | b <- [0.3, 2.5, 2.65, 5, 40],
            let report = exactReport 100 (fromPole b)
        ]
    it "counts the points it draws" $
      sequence_
        [ reportSteps report `shouldBe` length (reportPath report)
          | b <- [0, 2.5, 2.65],
            let report = exactReport 100 (fromPole b)
        ]
    it "has no angular momentum to lose on a radial path" $
      reportAngularMomentumDrift (exactReport 100 (fromPole 0)) `shouldBe` Nothing
    it "draws neighbouring points close together, from 100 radii to the end" $ do
      let points = [p | PathPoint _ p <- reportPath (exactReport 100 (fromPole 2.65))]
      map XYZ.norm (take 1 points ++ take 1 (reverse points))
        `shouldSatisfy` all (\r -> abs (r - 100) < 1e-6)
      zipWith (\p q -> XYZ.distance p q / XYZ.norm p) points (drop 1 points)
        `shouldSatisfy` all (< 0.021)
  describe "the leapfrog's report" $ do
    it "has an error that falls fourfold when the step is halved" $ do
      let exact = exactReport 100 camera
          stepped = [leapfrogReport (EqualSteps l) 100 camera | l <- [0.1, 0.05, 0.025]]
      sequence_
        [ ratios [errorOf value report exact | report <- stepped]
            `shouldSatisfy` all (\q -> abs (q - 4) < 0.5)
          | value <-
              [ reportSweptAngle,
                reportClosestApproach,
                fmap crossingRadius . firstCrossing,
                fmap crossingLight . firstCrossing,
                reportEnergyDrift
              ]
        ]
    it "is second order at the horizon too" $
      ratios
        [ errorOf
            reportSweptAngle
            (leapfrogReport (EqualSteps l) 100 plunging)
            (exactReport 100 plunging)
          | l <- [0.04, 0.02, 0.01]
        ]
        `shouldSatisfy` all (\q -> abs (q - 4) < 0.6)
    it "is close to the exact one with the report's own steps" $ do
      let difference =
            reportDifference (leapfrogReport reportStepRule 100 camera) (exactReport 100 camera)
      fromMaybe nan (differenceSweptAngle difference) `shouldBeWithin` (2e-3, 0)
      fromMaybe nan (differenceClosestApproach difference) `shouldBeWithin` (2e-3, 0)
      length (differenceCrossings difference) `shouldBe` 2
    it "shifts the light of gas as the exact one does, where it orbits and where it falls" $
      sequence_
        [ do
            length (differenceCrossings difference) `shouldBe` n
            map crossingLight (differenceCrossings difference) `shouldSatisfy` all ((< 1e-3) . abs)
          | (r, i, psi, eta, n) <-
              [(10, 45, 16, 200, 2), (20, 80, 10, 0, 1), (20, 80, 7, 90, 1), (1.2, 80, 100, 10, 0)],
            Just trajectory <-
              [ trajectoryFromCamera
                  (Sight (toRadians (Degrees i)) (toRadians (Degrees eta)))
                  r
                  (toRadians (Degrees psi))
              ],
            let difference =
                  reportDifference
                    (leapfrogReport (ReportSteps 0.02 0.01) 100 trajectory)
                    (exactReport 100 trajectory)
        ]
    it "keeps h to rounding" $
      fromMaybe nan (reportAngularMomentumDrift (leapfrogReport reportStepRule 100 camera))
        `shouldBeWithin` (1e-11, 0)
    it "tells fates" $
      [ fateName (reportFate (leapfrogReport reportStepRule 100 (fromPole b)))
        | b <- [0, 0.3, 2.5, 2.7, 30, 3000]
      ]
        `shouldBe` ["captured", "captured", "captured", "escaped", "escaped", "escaped"]
    it "draws what the exact one draws" $ do
      let points =
            [ p
              | PathPoint _ p <-
                  reportPath
                    (leapfrogReport (ReportSteps 0.02 0.01) 100 (fromPole 3))
            ]
          exact = [p | PathPoint _ p <- reportPath (exactReport 100 (fromPole 3))]
          near p = minimum (map (XYZ.distance p) exact)
      points `shouldSatisfy` all (\p -> XYZ.norm p > 30 || near p < 0.03 * XYZ.norm p)
  describe "differences" $
    it "of a report from itself are nothing" $ do
      let report = exactReport 100 camera
          difference = reportDifference report report
      differenceSweptAngle difference `shouldBe` Just 0
      differenceCrossings difference `shouldBe` [PlaneCrossing 0 0 0, PlaneCrossing 0 0 0]
  where
    nan = 0 / 0
    fromPole = trajectoryFromInfinity (Sight (Radians 0) (Radians 0))
    firstCrossing report = case reportCrossings report of
      c : _ -> Just c
      [] -> Nothing
    -- A row of the reference rays with two crossings.
    camera = fromCamera 10
    fromCamera psi =
      fromMaybe (fromPole 3) $
        trajectoryFromCamera
          (Sight (toRadians (Degrees 80)) (toRadians (Degrees (-90))))
          20
          (toRadians (Degrees psi))
    -- This one falls in.
    plunging = fromCamera 5
    errorOf value report exact =
      fromMaybe nan ((\a b -> abs (a - b)) <$> value report <*> value exact)
    ratios errors = zipWith (/) errors (drop 1 errors)
