-- | @blackhole photon@: its options, and what it prints about one light path.
module BlackHole.Cli.Photon
  ( -- * Options
    PhotonOptions (..),
    photonOptions,

    -- * The task
    PhotonTask (..),
    resolvePhoton,

    -- * Its outcome
    PhotonOutcome (..),
    photonOutcome,
    outcomeText,
    outcomeCsv,
  )
where

import BlackHole.Cli.Check
import BlackHole.Cli.Json
import BlackHole.Cli.Read
import BlackHole.Physics.Angle
import BlackHole.Physics.Course
import BlackHole.Physics.Leapfrog (StepRule (..), reportStepRule)
import BlackHole.Physics.PathReport
import BlackHole.Scene.Scene (Integrator (..), integratorName)
import BlackHole.Scene.Validate (Problem (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.List (intercalate, transpose)
import Data.Maybe (fromMaybe)
import Options.Applicative

-- | The options of @blackhole photon@.
data PhotonOptions = PhotonOptions
  { photonImpact :: !(Maybe Double),
    photonDistance :: !(Maybe Double),
    photonInclination :: !(Maybe Double),
    photonPsi :: !(Maybe Double),
    photonEta :: !(Maybe Double),
    photonIntegrator :: !Integrator,
    photonStep :: !(Maybe Double),
    photonJson :: !Bool,
    photonPath :: !(Maybe FilePath)
  }
  deriving (Eq, Show)

-- | Their grammar.
photonOptions :: Parser PhotonOptions
photonOptions =
  PhotonOptions
    <$> setting (option number (long "impact" <> metavar "B" <> help "Light from infinity with this impact parameter, in Schwarzschild radii"))
    <*> setting (option number (long "distance" <> metavar "R" <> help "Instead: the line of sight of a camera at rest, this far from the hole"))
    <*> setting (option number (long "inclination" <> metavar "DEGREES" <> help "Observer's angle from the disk's axis (with --impact 0 by default)"))
    <*> setting (option number (long "psi" <> metavar "DEGREES" <> help "With --distance: angle of the line of sight from the hole's centre"))
    <*> setting (option number (long "eta" <> metavar "DEGREES" <> help "Position angle about the hole's centre, from right towards up (with --impact 0 by default)"))
    <*> settingOr Exact (option (named "an integrator" [(integratorName i, i) | i <- [Exact, Leapfrogging]]) (long "integrator" <> metavar "NAME" <> help "exact, or leapfrog with its errors beside the exact values"))
    <*> setting (option number (long "step" <> metavar "L" <> help "The leapfrog's base length in Schwarzschild radii (default: 0.1)"))
    <*> toggle (long "json" <> help "Print JSON instead of a table")
    <*> setting (strOption (long "path" <> metavar "FILE.csv" <> help "Also write the path: swept angle, r, x, y, z"))

-- | A light path to look into.
data PhotonTask = PhotonTask
  { taskCourse :: !Course,
    -- | The step rule of the leapfrog, if that is to follow the path too.
    taskLeapfrog :: !(Maybe StepRule)
  }

-- | The path that the options describe, or everything that is wrong with them
-- (at least one problem).
resolvePhoton :: PhotonOptions -> Either [Problem] PhotonTask
resolvePhoton options = case (startProblems ++ stepProblems ++ pathProblems, course) of
  ([], Just path) -> Right (PhotonTask path rule)
  (problems, _) -> Left problems
  where
    (startProblems, course) = case (photonImpact options, photonDistance options, photonPsi options) of
      (Just b, Nothing, Nothing) ->
        ( checkNumber "--impact" (\v -> v >= 0 && v <= 1e6) "a length from 0 to 1e6 (Schwarzschild radii)" b
            ++ foldMap (checkNumber "--inclination" inclinationGood inclinationRange) (photonInclination options)
            ++ foldMap (checkNumber "--eta" etaGood etaRange) (photonEta options),
          Just (courseFromInfinity sight b)
        )
      (Just _, _, _) ->
        ([Problem "--impact" "together with --distance or --psi" "one way to give a light path; choose either"], Nothing)
      (Nothing, Nothing, Nothing) ->
        ([Problem "--impact" "nothing" "enough to know the light path; give --impact B, or --distance R --inclination I --psi P --eta E"], Nothing)
      (Nothing, distance, psi) ->
        ( requireNumber "--distance" (\r -> r > 1 && r <= 1e6) "a distance above 1 and up to 1e6 (Schwarzschild radii)" distance
            ++ requireNumber "--inclination" inclinationGood inclinationRange (photonInclination options)
            ++ requireNumber "--psi" (\a -> a >= 0 && a <= 180) "an angle from 0 to 180 (degrees from the hole's centre)" psi
            ++ requireNumber "--eta" etaGood etaRange (photonEta options),
          do
            r <- distance
            angle <- psi
            courseFromCamera sight r (toRadians (Degrees angle))
        )
    sight = Sight (angleOf photonInclination) (angleOf photonEta)
    angleOf field = toRadians (Degrees (fromMaybe 0 (field options)))
    inclinationGood i = i >= 0 && i <= 180
    inclinationRange = "an angle from 0 to 180 (degrees from the disk's axis)"
    etaGood a = abs a <= 360
    etaRange = "an angle from -360 to 360 (degrees from right towards up)"
    (rule, stepProblems) = case (photonIntegrator options, photonStep options) of
      (Leapfrogging, Just l) ->
        ( Just (ReportSteps l reportWidth),
          checkNumber "--step" (\v -> v >= 1e-5 && v <= 10) "a length from 0.00001 to 10 (Schwarzschild radii)" l
        )
      (Leapfrogging, Nothing) -> (Just reportStepRule, [])
      (_, Just l) -> (Nothing, [Problem "--step" (showDouble l) "of use to the exact integrator; add --integrator leapfrog"])
      (_, Nothing) -> (Nothing, [])
    -- The thickness of the disk in the report's rule.
    reportWidth = case reportStepRule of
      ReportSteps _ w -> w
      EqualSteps _ -> 0.01
    pathProblems = [Problem "--path" "an empty name" "a file to write" | photonPath options == Just ""]

-- | What is known about the path in the end.
data PhotonOutcome
  = -- | The closed form alone.
    ExactOutcome !PathReport
  | -- | The leapfrog's report, and the exact one.
    LeapfrogOutcome !PathReport !PathReport
  deriving (Eq, Show)

-- | Follow the photon. The path is drawn out to 100 Schwarzschild radii, to
-- the camera, or to four times the impact parameter, whichever is greatest.
photonOutcome :: PhotonTask -> PhotonOutcome
photonOutcome (PhotonTask course leapfrog) = case leapfrog of
  Nothing -> ExactOutcome exact
  Just rule -> LeapfrogOutcome (leapfrogReport rule drawn course) exact
  where
    exact = exactReport drawn course
    drawn = max 100 (4 * courseImpactParameter course)

-- | The outcome as a table, or as JSON.
outcomeText :: Bool -> PhotonOutcome -> String
outcomeText json outcome
  | json = renderJson . Object $ case outcome of
    ExactOutcome report -> reportMembers report
    LeapfrogOutcome report exact ->
      reportMembers report
        ++ [ ("exact", Object (reportMembers exact)),
             ("error", Object (differenceMembers (reportDifference report exact)))
           ]
  | otherwise = table $ case outcome of
    ExactOutcome report -> flatten (reportMembers report)
    LeapfrogOutcome report exact ->
      ["", "leapfrog", "exact", "error"] :
      besides (flatten (reportMembers report)) (flatten (reportMembers exact)) (flatten (differenceMembers (reportDifference report exact)))
  where
    besides rows exact errors =
      [ [name, content, cell name exact, cell name errors]
        | name <- map label rows ++ filter (`notElem` map label rows) (map label exact),
          let content = cell name rows
      ]
    cell name = fromMaybe "-" . lookup name . map pair
    label = fst . pair
    pair row = case row of
      [name, content] -> (name, content)
      _ -> ("", "")

reportMembers :: PathReport -> [(String, Json)]
reportMembers report =
  [ ("fate", Text (reportFate report)),
    ("impactParameter", maybeNumber (reportImpactParameter report)),
    ("sweptAngle", maybeNumber (reportSweptAngle report)),
    ("deflection", maybeNumber (reportDeflection report)),
    ("closestApproach", maybeNumber (reportClosestApproach report)),
    ("crossings", crossingList (reportCrossings report)),
    ("steps", Whole (reportSteps report)),
    ("angularMomentumDrift", maybeNumber (reportAngularMomentumDrift report)),
    ("energyDrift", maybeNumber (reportEnergyDrift report))
  ]

differenceMembers :: PathDifference -> [(String, Json)]
differenceMembers difference =
  [ ("impactParameter", maybeNumber (differenceImpactParameter difference)),
    ("sweptAngle", maybeNumber (differenceSweptAngle difference)),
    ("deflection", maybeNumber (differenceDeflection difference)),
    ("closestApproach", maybeNumber (differenceClosestApproach difference)),
    ("crossings", crossingList (differenceCrossings difference)),
    ("angularMomentumDrift", maybeNumber (differenceAngularMomentumDrift difference)),
    ("energyDrift", maybeNumber (differenceEnergyDrift difference))
  ]

crossingList :: [Crossing] -> Json
crossingList crossings =
  List
    [ Object [("r", Number r), ("azimuth", Number azimuth), ("g", Number g)]
      | Crossing r azimuth g <- crossings
    ]

maybeNumber :: Maybe Double -> Json
maybeNumber = maybe Null Number

-- | One row of name and content for every single value.
flatten :: [(String, Json)] -> [[String]]
flatten = concatMap (uncurry rows)
  where
    rows name json = case json of
      List items -> concat (zipWith (\n item -> rows (name ++ "[" ++ show n ++ "]") item) [1 :: Int ..] items)
      Object members -> concatMap (\(key, member) -> rows (name ++ "." ++ key) member) members
      Text s -> [[name, s]]
      Number d -> [[name, showDouble d]]
      Whole n -> [[name, show n]]
      Truth b -> [[name, if b then "yes" else "no"]]
      Null -> [[name, "-"]]

-- | Columns of equal width, without blanks at the ends of lines.
table :: [[String]] -> String
table rows = unlines (map line rows)
  where
    widths = map (maximum . map length) (transpose rows)
    line row = dropBlanks (intercalate "  " (zipWith padded widths row))
    padded n s = s ++ replicate (n - length s) ' '
    dropBlanks = reverse . dropWhile (== ' ') . reverse

-- | The path that was followed, as CSV: swept angle in radians, and radius and
-- place in Schwarzschild radii.
outcomeCsv :: PhotonOutcome -> Lazy.ByteString
outcomeCsv outcome = Builder.toLazyByteString (foldMap line (heading : map row points))
  where
    heading = ["swept_angle_rad", "r", "x", "y", "z"]
    points = reportPath $ case outcome of
      ExactOutcome report -> report
      LeapfrogOutcome report _ -> report
    row (PathPoint angle place@(XYZ x y z)) = map showDouble [angle, XYZ.norm place, x, y, z]
    line cells = Builder.string7 (intercalate "," cells) <> Builder.char7 '\n'
