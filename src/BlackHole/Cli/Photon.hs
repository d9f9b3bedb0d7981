-- | @blackhole photon@: its options, and its report on one light path.
module BlackHole.Cli.Photon
  ( -- * Options
    PhotonOptions (..),
    photonOptions,

    -- * The task
    PhotonTask,
    resolvePhoton,

    -- * Its outcome
    PhotonOutcome (..),
    photonOutcome,
    outcomeText,
    outcomePoints,
    outcomeCsv,
  )
where

import BlackHole.Cli.Check
import BlackHole.Cli.Json
import BlackHole.Cli.Read
import BlackHole.Numeric.Angle
import BlackHole.Scene.Scene (Integrator (..), integratorName)
import BlackHole.Scene.Validate (Problem (..))
import BlackHole.Spacetime.Kerr.Landmarks (Spin, ergosphereRadius, spin)
import BlackHole.Spacetime.Kerr.Path (KerrFate (Escapes))
import qualified BlackHole.Spacetime.Kerr.Path as Kerr
import BlackHole.Spacetime.Kerr.PathReport
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.PathReport
import BlackHole.Spacetime.Schwarzschild.Leapfrog (StepRule (..), reportStepRule)
import BlackHole.Spacetime.Schwarzschild.Trajectory
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import qualified Data.ByteString.Builder as Builder
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isUpper, toLower)
import Data.List (intercalate, isSuffixOf, stripPrefix, transpose)
import Data.Maybe (fromMaybe)
import Options.Applicative

-- | The options of @blackhole photon@.
data PhotonOptions = PhotonOptions
  { photonImpact :: !(Maybe Double),
    photonDistance :: !(Maybe Double),
    photonInclination :: !(Maybe Double),
    photonSpin :: !(Maybe Double),
    photonPsi :: !(Maybe Double),
    photonEta :: !(Maybe Double),
    photonIntegrator :: !Integrator,
    photonStep :: !(Maybe Double),
    photonJson :: !Bool,
    photonPath :: !(Maybe FilePath),
    -- | Do not report that the path is written.
    photonQuiet :: !Bool
  }
  deriving (Eq, Show)

-- | Their parser.
photonOptions :: Parser PhotonOptions
photonOptions =
  PhotonOptions
    <$> setting (option number (long "impact" <> metavar "B" <> help "Follow light from infinity with this impact parameter, in r_s"))
    <*> setting (option number (long "distance" <> metavar "R" <> help ("Distance of the camera from the hole in r_s, with --psi (default: " ++ showDouble standardDistance ++ ")")))
    <*> setting (option number (long "inclination" <> metavar "DEGREES" <> help ("Angle between the disk's axis and the camera, or the direction that the light goes to (default: " ++ showDouble standardInclination ++ ")")))
    <*> setting (option number (long "spin" <> metavar "A" <> help "Spin of the hole, from -1 to 1, positive if it turns with the disk (default: 0)"))
    <*> setting (option number (long "psi" <> metavar "DEGREES" <> help "Follow the line of sight at this angle from the direction of the hole's centre"))
    <*> setting (option number (long "eta" <> metavar "DEGREES" <> help ("Position angle of the path about the hole's centre, from right towards up (default: " ++ showDouble standardEta ++ ")")))
    <*> settingOr Exact (option (named "an integrator" [(integratorName i, i) | i <- [minBound ..]]) (long "integrator" <> metavar "NAME" <> completeWith (map integratorName [minBound ..]) <> help "How to follow the light: exact (closed form), table (as render does by default) or leapfrog; the latter two with their errors (default: exact)"))
    <*> setting (option number (long "step" <> metavar "L" <> help "Base step length of the leapfrog in r_s (default: 0.1)"))
    <*> toggle (long "json" <> help "Print JSON instead of a table")
    <*> setting (strOption (long "path" <> metavar "FILE.csv" <> action "file" <> help "Also write the points of the path: swept angle, r, x, y, z"))
    <*> toggle (long "quiet" <> short 'q' <> help "Do not report that the path is written")

-- The camera of the default scene, and a line of sight to the right of the hole.
standardDistance, standardInclination, standardEta :: Double
standardDistance = 30
standardInclination = 82
standardEta = 0

-- | A light path, and how to follow it.
data PhotonTask
  = PhotonTask !Trajectory !Method
  | -- | Around a rotating hole.
    RotatingTask !Spin !LightRay

-- | The ways to follow it.
data Method
  = ClosedForm
  | Leapfrog !StepRule
  | -- | The same path from the renderer's table.
    FromTable !Trajectory

-- | The path that the options describe, or all their mistakes (at least one).
resolvePhoton :: PhotonOptions -> Either [Problem] PhotonTask
resolvePhoton options = case photonSpin options of
  Just s | s /= 0 -> resolveRotating options s
  _ -> resolvePlanar options

-- | The path of a line of sight around a hole of a spin other than 0, for which there is
-- the closed form only.
resolveRotating :: PhotonOptions -> Double -> Either [Problem] PhotonTask
resolveRotating options s = case (problems, ray) of
  ([], Right found) -> Right found
  ([], Left problem) -> Left [problem]
  _ -> Left problems
  where
    problems =
      checkNumber "--spin" (\v -> abs v < 1) "a spin above -1 and below 1" s
        ++ [Mistake "--impact" "applies only without --spin; a path around a rotating hole has no impact parameter" | Just _ <- [photonImpact options]]
        ++ [Mistake "--psi" "missing; give --psi DEGREES for a line of sight" | Nothing <- [photonPsi options], Nothing <- [photonImpact options]]
        ++ [Mistake "--integrator" (integratorName (photonIntegrator options) ++ " applies only without --spin") | photonIntegrator options /= Exact]
        ++ [Mistake "--step" (showDouble l ++ " has no effect; it applies only with --integrator leapfrog") | Just l <- [photonStep options]]
        ++ checkNumber "--distance" (\r -> r > 0.5 && r <= 1e6) "a distance outside the ergosphere and up to 1e6 (Schwarzschild radii)" distance
        ++ foldMap (checkNumber "--psi" (\a -> a >= 0 && a <= 180) "an angle from 0 to 180 (degrees from the direction of the hole's centre)") (photonPsi options)
        ++ checkNumber "--inclination" (\i -> i >= 0 && i <= 180) "an angle from 0 to 180 (degrees from the disk's axis)" inclination
        ++ checkNumber "--eta" (\a -> abs a <= 360) "an angle from -360 to 360 (degrees from right towards up)" (fromMaybe standardEta (photonEta options))
        ++ pathNameProblems options
    distance = fromMaybe standardDistance (photonDistance options)
    inclination = fromMaybe standardInclination (photonInclination options)
    radians = (\(Radians v) -> v) . toRadians . Degrees
    psi = radians (fromMaybe 0 (photonPsi options))
    eta = radians (fromMaybe standardEta (photonEta options))
    direction = Direction (negate (cos psi)) (negate (sin psi * sin eta)) (sin psi * cos eta)
    ray = case spin s of
      Just hole -> maybe (Left (tooClose hole)) (Right . RotatingTask hole) (lightRay hole (Place distance (radians inclination)) AtRest direction)
      Nothing -> Left (Problem "--spin" (showDouble s) "a spin above -1 and below 1")
    tooClose hole =
      Problem "--distance" (showDouble distance) $
        "a distance above " ++ showDouble (ergosphereRadius hole (cos (radians inclination))) ++ ", outside the ergosphere (Schwarzschild radii)"

-- | The path around a hole that does not rotate.
resolvePlanar :: PhotonOptions -> Either [Problem] PhotonTask
resolvePlanar options = case (problems, trajectory, method) of
  ([], Just path, Just way) -> Right (PhotonTask path way)
  _ -> Left problems
  where
    problems = startProblems ++ sightProblems ++ methodProblems ++ pathNameProblems options
    (startProblems, trajectory) = case (photonImpact options, photonPsi options) of
      (Just b, Nothing)
        | Nothing <- photonDistance options ->
          (checkNumber "--impact" (\v -> v >= 0 && v <= 1e6) "a length from 0 to 1e6 (Schwarzschild radii)" b, Just (trajectoryFromInfinity sight b))
      (Just _, _) -> ([Mistake "--impact" "cannot be combined with --psi or --distance"], Nothing)
      (Nothing, Nothing) -> ([Mistake "--psi" "missing; give --psi DEGREES for a line of sight, or --impact B for light from infinity"], Nothing)
      (Nothing, Just angle) ->
        ( checkNumber "--distance" (\r -> r > 1 && r <= 1e6) "a distance above 1 and up to 1e6 (Schwarzschild radii)" distance
            ++ checkNumber "--psi" (\a -> a >= 0 && a <= 180) "an angle from 0 to 180 (degrees from the direction of the hole's centre)" angle,
          trajectoryFromCamera sight distance (toRadians (Degrees angle))
        )
    distance = fromMaybe standardDistance (photonDistance options)
    inclination = fromMaybe standardInclination (photonInclination options)
    eta = fromMaybe standardEta (photonEta options)
    sight = Sight (toRadians (Degrees inclination)) (toRadians (Degrees eta))
    sightProblems =
      checkNumber "--inclination" (\i -> i >= 0 && i <= 180) "an angle from 0 to 180 (degrees from the disk's axis)" inclination
        ++ checkNumber "--eta" (\a -> abs a <= 360) "an angle from -360 to 360 (degrees from right towards up)" eta
    (methodProblems, method) = case (photonIntegrator options, photonStep options) of
      (Leapfrogging, Just l) -> (checkNumber "--step" (\v -> v >= 1e-5 && v <= 10) "a length from 0.00001 to 10 (Schwarzschild radii)" l, Just (Leapfrog (ReportSteps l reportWidth)))
      (_, Just l) -> ([Mistake "--step" (showDouble l ++ " has no effect; it applies only with --integrator leapfrog")], Nothing)
      (Leapfrogging, Nothing) -> ([], Just (Leapfrog reportStepRule))
      (Exact, Nothing) -> ([], Just ClosedForm)
      (Tabulated, Nothing) -> case photonPsi options of
        Just angle -> ([], FromTable <$> trajectoryFromTable sight distance (toRadians (Degrees angle)))
        Nothing -> ([Mistake "--integrator" "table applies only with --psi; it holds the paths that start at the camera's distance"], Nothing)
    -- The thickness of the disk in the step rule of the design report.
    reportWidth = case reportStepRule of
      ReportSteps _ w -> w
      EqualSteps _ -> 0.01

pathNameProblems :: PhotonOptions -> [Problem]
pathNameProblems options = [Problem "--path" "an empty name" "the name of a file" | photonPath options == Just ""]

-- | The reports on a path.
data PhotonOutcome
  = -- | That of the closed form alone.
    ExactOutcome !PathReport
  | -- | That of another method, whose name comes first, and that of the closed form.
    ComparedOutcome !String !PathReport !PathReport
  | -- | That of the closed form around a rotating hole.
    RotatingOutcome !KerrReport
  deriving (Eq, Show)

-- | Follow the light. The path's points extend to 100 Schwarzschild radii, to the
-- camera, or to four times the impact parameter, whichever is farthest.
photonOutcome :: PhotonTask -> PhotonOutcome
photonOutcome (RotatingTask hole ray) = RotatingOutcome (kerrReport hole 100 ray)
photonOutcome (PhotonTask trajectory method) = case method of
  ClosedForm -> ExactOutcome exact
  Leapfrog rule -> ComparedOutcome "leapfrog" (leapfrogReport rule drawn trajectory) exact
  FromTable tabulated -> ComparedOutcome "table" (exactReport drawn tabulated) exact
  where
    exact = exactReport drawn trajectory
    drawn = max 100 (4 * trajectoryImpactParameter trajectory)

-- | The outcome as JSON or, with 'False', as a table with units.
outcomeText :: Bool -> PhotonOutcome -> String
outcomeText json outcome
  | json = renderJson . Object $ case outcome of
    ExactOutcome report -> reportMembers report
    ComparedOutcome _ report exact ->
      reportMembers report
        ++ [ ("exact", Object (reportMembers exact)),
             ("error", Object (differenceMembers (reportDifference report exact)))
           ]
    RotatingOutcome report -> rotatingMembers report
  | otherwise = case outcome of
    ExactOutcome report -> table [[name, content, unitOf name] | (name, content) <- rows report] ++ legend report
    ComparedOutcome name report exact ->
      table (["", name, "exact", "error", ""] : besides (rows report) (rows exact) (flatten (differenceMembers (reportDifference report exact))))
        ++ legend report
    RotatingOutcome report -> table [[name, content, unitOf name] | (name, content) <- flatten (rotatingMembers report)] ++ legendOf (not (null (kerrReportCrossings report)))
  where
    rows = flatten . reportMembers
    besides own exact errors =
      [ [name, cell name own, cell name exact, cell name errors, unitOf name]
        | name <- map fst own ++ filter (`notElem` map fst own) (map fst exact)
      ]
    cell name = fromMaybe "-" . lookup name
    legend report =
      unlines ["", "r_s is the Schwarzschild radius 2GM/c^2. A drift is relative to the value at the start."]
        ++ legendOf (not (null (reportCrossings report)))
    legendOf crosses =
      unlines
        ( if not crosses
            then []
            else
              [ "A crossing is a point where the path crosses the disk's plane; its azimuth is",
                "atan2(z, x). g is the frequency that the observer measures over the frequency",
                "that gas emits there, on its circular orbit or, inside the innermost stable one,",
                "falling inwards."
              ]
        )

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

rotatingMembers :: KerrReport -> [(String, Json)]
rotatingMembers report =
  [ ("fate", Text fate),
    ("lambda", Number (kerrReportLambda report)),
    ("carterQ", Number (kerrReportCarter report)),
    ("minoTime", Number (kerrReportMinoTime report)),
    ("frequency", Number (kerrReportObserved report)),
    ("escapeDirection", direction),
    ( "crossings",
      List
        [ Object [("r", Number r), ("azimuth", Number azimuth), ("g", Number g)]
          | KerrCrossing r azimuth g <- kerrReportCrossings report
        ]
    )
  ]
  where
    (fate, direction) = case kerrReportFate report of
      Escapes (XYZ x y z) -> ("escaped", List [Number x, Number y, Number z])
      Kerr.Captured -> ("captured", Null)
      Kerr.Circles -> ("circles", Null)

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

-- | The name and content of every single value.
flatten :: [(String, Json)] -> [(String, String)]
flatten = concatMap (uncurry rows)
  where
    rows name json = case json of
      List items -> concat (zipWith (\n item -> rows (spaced name ++ " " ++ show n) item) [1 :: Int ..] items)
      Object members -> concatMap (\(key, member) -> rows (singular name ++ ", " ++ key) member) members
      Text s -> [(spaced name, s)]
      Number d -> [(spaced name, showDouble d)]
      Whole n -> [(spaced name, show n)]
      Truth b -> [(spaced name, if b then "yes" else "no")]
      Null -> [(spaced name, "-")]
    -- JSON's "impactParameter" is "impact parameter" in the table.
    spaced = concatMap (\c -> if isUpper c then [' ', toLower c] else [c])
    singular name = fromMaybe name (stripPrefix "crossings" name >>= Just . ("crossing" ++))

-- | The unit of the value of this name in the table.
unitOf :: String -> String
unitOf name
  | any (`isSuffixOf` name) ["impact parameter", "closest approach", "lambda", ", r"] = "r_s"
  | "carter q" `isSuffixOf` name = "r_s^2"
  | "mino time" `isSuffixOf` name = "1/r_s"
  | any (`isSuffixOf` name) ["angle", "deflection", "azimuth"] = "rad"
  | otherwise = ""

-- | Columns, without blanks at the ends of lines.
table :: [[String]] -> String
table rows = unlines (map line rows)
  where
    widths = map (maximum . map length) (transpose rows)
    line row = dropBlanks (intercalate "  " (zipWith padded widths row))
    padded n s = s ++ replicate (n - length s) ' '
    dropBlanks = reverse . dropWhile (== ' ') . reverse

-- | The points of the path.
outcomePoints :: PhotonOutcome -> [PathPoint]
outcomePoints outcome = case outcome of
  ExactOutcome report -> reportPath report
  ComparedOutcome _ report _ -> reportPath report
  RotatingOutcome report -> [PathPoint time place | KerrPathPoint time place <- kerrReportPath report]

-- | The points of the path as CSV: swept angle in radians (around a rotating hole, Mino
-- time), and radius and position in Schwarzschild radii.
outcomeCsv :: PhotonOutcome -> Lazy.ByteString
outcomeCsv outcome = Builder.toLazyByteString (foldMap line (heading : map row (outcomePoints outcome)))
  where
    heading = [parameter, "r", "x", "y", "z"]
    parameter = case outcome of
      RotatingOutcome _ -> "mino_time"
      _ -> "swept_angle_rad"
    row (PathPoint angle place@(XYZ x y z)) = map showDouble [angle, XYZ.norm place, x, y, z]
    line cells = Builder.string7 (intercalate "," cells) <> Builder.char7 '\n'
